"""A machine on the real ROS 2 network (default link, loopback): round trips through it, and what three turtles with tf cost.

`python -m benchmarks.network` needs `edulaunch[network]`. Nothing leaves the loopback; each part lasts a few seconds.
"""

from __future__ import annotations

import os
import select
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

import edulaunch

DOMAIN = 101
PINGS = 300
SECONDS = 10.0
ECHO = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

rclpy.init()
node = Node('echo')
publisher = node.create_publisher(String, '/pong', 10)
node.create_subscription(String, '/ping', publisher.publish, 10)
rclpy.spin(node)
"""
TURTLES = """
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    return LaunchDescription([
        node for name in ('a', 'b', 'c') for node in (
            Node(package='turtlesim', executable='turtlesim_node', namespace=name),
            Node(package='turtle_tf2_py', executable='turtle_tf2_broadcaster', namespace=name, name='broadcaster',
                 parameters=[{'turtlename': f'{name}/turtle1'}], remappings=[(f'/{name}/turtle1/pose', f'/{name}/turtle1/pose')]),
        )
    ])
"""


def host(words: list[str], link: str, until_closed: bool = True) -> None:
    """A machine with one command, until its input ends; tells its share of a processor over the last seconds."""
    from edulaunch.network.bridge import Bridge
    from edulaunch.network.link import Settings
    from edulaunch.network.links import make_link
    from edulaunch.processes.shared_streams import streams_of_programs
    from edulaunch.processes.spec import ProcessSpec
    from edulaunch.session import Session
    from edulaunch.sim.pacing import RealTime

    session = Session(start_ns=time.time_ns())
    session.host.is_paced = True
    session.host.start(ProcessSpec(argv=tuple(words), name='command', cwd=os.getcwd(), env=dict(session.host.env)))
    pace = RealTime(session.sim)
    bridge = None
    if link != 'none':
        pace.is_wall = True
        bridge = Bridge(session, make_link(link))
        bridge.open(Settings(DOMAIN))
    watched: list[Any] = [0, *([] if bridge is None else [bridge.link])]
    print('begun', flush=True)
    marks: list[tuple[float, float]] = []
    with streams_of_programs():
        while True:
            wait_s = pace.advance()
            if bridge is not None:
                bridge.after_turn()
            ready = select.select(watched, [], [], 1.0 if wait_s is None else wait_s)[0]
            if 0 in ready:
                if not os.read(0, 100):
                    break
                marks.append((time.monotonic(), time.process_time()))
                print(f'{bridge.sent if bridge else 0}', flush=True)
            if bridge is not None and bridge.link in ready:
                pace.advance()
                bridge.take()
    (began, before), (ended, after) = marks[0], marks[-1]
    print(f'{(after - before) / (ended - began):.5f}', flush=True)
    os._exit(0)


class Host:
    """That machine, in a process of its own."""

    def __init__(self, words: list[str], link: str) -> None:
        pipe = subprocess.PIPE
        self.program = subprocess.Popen(
            [sys.executable, '-m', 'benchmarks.network', link, *words], stdin=pipe, stdout=pipe, text=True
        )
        self.hear()

    def hear(self) -> str:
        assert self.program.stdout is not None
        return self.program.stdout.readline().strip()

    def mark(self) -> str:
        assert self.program.stdin is not None
        self.program.stdin.write('x')
        self.program.stdin.flush()
        return self.hear()

    def end(self) -> float:
        self.program.stdin.close()  # type: ignore[union-attr]
        share = float(self.hear())
        self.program.wait()
        return share


def joined() -> Any:
    """Somebody on the network who is no machine."""
    from edulaunch.network.link import Settings
    from edulaunch.network.links import make_link

    link = make_link()
    link.open(Settings(DOMAIN))
    return link


def round_trips(folder: Path) -> dict[str, float]:
    """A String to a simulated node and back."""
    from edulaunch.graph.qos import QoS
    from edulaunch.interfaces.cdr import encode
    from edulaunch.interfaces.registry import underlay_registry
    from edulaunch.network.link import Interface, Message

    (folder / 'echo.py').write_text(ECHO)
    machine, link = Host(['python3', str(folder / 'echo.py')], 'cyclonedds'), joined()
    interface = Interface('std_msgs/msg/String', underlay_registry())
    node = link.add_node('/', 'pinger')
    mouth = link.add(node, 'publisher', '/ping', interface, QoS())
    link.add(node, 'subscription', '/pong', interface, QoS())
    link.flush()
    cls, times = interface.registry.get(interface.name), []
    while len(times) < PINGS:
        began = time.perf_counter()
        link.publish(mouth, encode(cls, (str(len(times)),)))
        while time.perf_counter() - began < 0.5:
            if select.select([link], [], [], 0.5)[0] and any(isinstance(event, Message) for event in link.take()):
                times.append(time.perf_counter() - began)
                break
        time.sleep(0.005)
    for _ in range(2):
        machine.mark()
        time.sleep(0.01)
    machine.end()
    link.close()
    times = sorted(times[20:])
    return {
        'round trip, median (ms)': statistics.median(times) * 1e3,
        'round trip, 95 of 100 (ms)': times[int(len(times) * 0.95)] * 1e3,
    }


def three_turtles(folder: Path) -> dict[str, float]:
    """The processor's share with and without the network, while somebody out there hears all poses and tf."""
    from edulaunch.graph.qos import QoS
    from edulaunch.interfaces.registry import underlay_registry
    from edulaunch.network.link import Interface, Message

    (folder / 'turtles.launch.py').write_text(TURTLES)
    figures: dict[str, float] = {}
    for link_name in ('none', 'cyclonedds'):
        machine = Host(['ros2', 'launch', str(folder / 'turtles.launch.py')], link_name)
        peer = joined()
        node, heard = peer.add_node('/', 'ear'), 0
        topics = {'/tf': 'tf2_msgs/msg/TFMessage', **{f'/{name}/turtle1/pose': 'turtlesim/msg/Pose' for name in 'abc'}}
        for topic, type_name in topics.items():
            peer.add(node, 'subscription', topic, Interface(type_name, underlay_registry()), QoS(depth=100))
        peer.flush()
        begun = time.monotonic() + 3.0
        sent, marked = '0', False
        while time.monotonic() < begun + SECONDS:
            if select.select([peer], [], [], 0.05)[0]:
                heard += sum(isinstance(event, Message) for event in peer.take()) * marked
            if not marked and time.monotonic() > begun:
                marked, sent = True, machine.mark()
        sent_now = machine.mark()
        share = machine.end()
        peer.close()
        if link_name == 'none':
            figures['three turtles with tf, network off (% of a core)'] = share * 100
        else:
            figures['three turtles with tf, bridged (% of a core)'] = share * 100
            figures['messages heard out there (1/s)'] = heard / SECONDS
            figures['messages sent (1/s)'] = (int(sent_now) - int(sent)) / SECONDS
    return figures


def measure() -> dict[str, float]:
    """All figures."""
    with tempfile.TemporaryDirectory() as folder:
        return {**round_trips(Path(folder)), **three_turtles(Path(folder))}


if __name__ == '__main__':
    edulaunch.source()
    if len(sys.argv) > 1:
        host(sys.argv[2:], sys.argv[1])
    for name, figure in measure().items():
        print(f'{name}: {figure:.4g}')
