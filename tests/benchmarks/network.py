"""A machine on the real ROS 2 network, on the loopback: round trips through it, what three turtles with tf cost, what is lost.

`python -m tests.benchmarks.network` needs `edulaunch[network]`, and for the full link `edulaunch network install`. A share of a
core is the time of a processor that the machine, or the full link's side process, has used, over the time on the wall.
"""

from __future__ import annotations

import os
import select
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
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
COUNTER = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

rclpy.init()
node, numbers = Node('counter'), []
publisher = node.create_publisher(String, '/pong', 10)

def heard(message):
    if message.data == 'end':
        publisher.publish(String(data=f'{len(numbers)} {sum(late <= early for early, late in zip(numbers, numbers[1:]))}'))
    else:
        numbers.append(int(message.data))

node.create_subscription(String, '/ping', heard, 10)
rclpy.spin(node)
"""
MESSAGES, A_SECOND = 4000, 2000
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
    from edulaunch.engine.processes.spec import ProcessSpec
    from edulaunch.engine.processes.streams import streams_of_programs
    from edulaunch.engine.sim.pacing import RealTime
    from edulaunch.extras.network.bridge import Bridge
    from edulaunch.extras.network.links import make_link
    from edulaunch.extras.network.network_link import Settings
    from edulaunch.runtime.session import Session

    session = Session(start_ns=time.time_ns())
    session.host.start(ProcessSpec(argv=tuple(words), name='command', cwd=os.getcwd(), env=dict(session.host.env)))
    pace = RealTime(session.sim)
    bridge = None
    if link != 'none':
        pace.is_wall = True
        bridge = Bridge(session, make_link(link))
        bridge.open(Settings(DOMAIN))
    watched: list[Any] = [0, *([] if bridge is None else [bridge.link])]
    print('begun', flush=True)
    side = getattr(getattr(bridge and bridge.link, '_child', None), 'pid', 0)
    marks: list[tuple[float, float, float]] = []
    with streams_of_programs():
        while True:
            wait_s = pace.advance()
            if bridge is not None:
                bridge.after_turn()
            ready = select.select(watched, [], [], 1.0 if wait_s is None else wait_s)[0]
            if 0 in ready:
                if not os.read(0, 100):
                    break
                marks.append((time.monotonic(), time.process_time(), used_s(side)))
                print(f'{bridge.sent if bridge else 0}', flush=True)
            if bridge is not None and bridge.link in ready:
                pace.advance()
                bridge.take()
    (began, *before), (ended, *after) = marks[0], marks[-1]
    print(*[f'{(late - early) / (ended - began):.5f}' for early, late in zip(before, after, strict=True)], flush=True)
    if bridge is not None:
        bridge.close()
    os._exit(0)


def used_s(pid: int) -> float:
    """Seconds of a processor that another process has used; 0 when there is none."""
    if not pid:
        return 0.0
    fields = Path(f'/proc/{pid}/stat').read_text().rpartition(')')[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf('SC_CLK_TCK')


class Host:
    """That machine, in a process of its own."""

    def __init__(self, words: list[str], link: str) -> None:
        pipe = subprocess.PIPE
        self.program = subprocess.Popen(
            [sys.executable, '-m', 'tests.benchmarks.network', link, *words], stdin=pipe, stdout=pipe, text=True
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

    def end(self) -> list[float]:
        """The shares of a processor: the machine's, and its side process's."""
        self.program.stdin.close()  # type: ignore[union-attr]
        shares = [float(share) for share in self.hear().split()]
        self.program.wait()
        return shares


def joined() -> Any:
    """Somebody on the network who is no machine."""
    from edulaunch.extras.network.links import make_link
    from edulaunch.extras.network.network_link import Settings

    link = make_link()
    link.open(Settings(DOMAIN))
    return link


class Pinger:
    """A machine with one program, and somebody out there who says Strings to it and hears what it says."""

    def __init__(self, folder: Path, text: str, link_name: str) -> None:
        from edulaunch.engine.graph.qos import QoS
        from edulaunch.engine.interfaces.registry import underlay_registry
        from edulaunch.extras.network.network_link import Interface

        (folder / 'program.py').write_text(text)
        self.machine, self.link = Host(['python3', str(folder / 'program.py')], link_name), joined()
        interface = Interface('std_msgs/msg/String', underlay_registry())
        self.cls = interface.registry.get(interface.name)
        node = self.link.add_node('/', 'pinger')
        self.mouth = self.link.add(node, 'publisher', '/ping', interface, QoS(depth=1000))
        self.link.add(node, 'subscription', '/pong', interface, QoS())
        self.link.flush()

    def say(self, text: str) -> None:
        from edulaunch.ros.serialization.cdr import encode

        self.link.publish(self.mouth, encode(self.cls, (text,)))

    def hear(self, longest_s: float) -> str | None:
        """The next answer; None when there is none for so long."""
        from edulaunch.extras.network.network_link import Message
        from edulaunch.ros.serialization.cdr import decode

        end_s = time.monotonic() + longest_s
        while (left_s := end_s - time.monotonic()) > 0:
            if select.select([self.link], [], [], left_s)[0]:
                for event in self.link.take():
                    if isinstance(event, Message):
                        return str(decode(self.cls, event.cdr)[0])
        return None

    def close(self) -> None:
        for _ in range(2):
            self.machine.mark()
            time.sleep(0.01)
        self.machine.end()
        self.link.close()


def round_trips(folder: Path, link_name: str) -> dict[str, float]:
    """A String to a simulated node and back."""
    pinger, times = Pinger(folder, ECHO, link_name), []
    while len(times) < PINGS:
        began = time.perf_counter()
        pinger.say(str(len(times)))
        if pinger.hear(0.5) is not None:
            times.append(time.perf_counter() - began)
        time.sleep(0.005)
    pinger.close()
    times = sorted(times[20:])
    return {
        f'{link_name}: round trip, median (ms)': statistics.median(times) * 1e3,
        f'{link_name}: round trip, 95 of 100 (ms)': times[int(len(times) * 0.95)] * 1e3,
    }


def flood(folder: Path, link_name: str) -> dict[str, float]:
    """Many messages a second, evenly, into a simulated node with a queue of 10."""
    pinger = Pinger(folder, COUNTER, link_name)
    while pinger.hear(0.2) is None:
        pinger.say('end')  # until both have found each other
    began = time.monotonic()
    for number in range(MESSAGES):
        time.sleep(max(0.0, began + number / A_SECOND - time.monotonic()))
        pinger.say(str(number))
    answer = None
    while answer is None or answer == '0 0':
        pinger.say('end')
        answer = pinger.hear(0.5)
    pinger.close()
    count, wrong = map(int, answer.split())
    return {
        f'{link_name}: lost of {MESSAGES} at {A_SECOND} a second': MESSAGES - count,
        f'{link_name}: of those out of order': wrong,
    }


def three_turtles(folder: Path, link_name: str) -> dict[str, float]:
    """The processor's share, while somebody out there hears all poses and tf."""
    from edulaunch.engine.graph.qos import QoS
    from edulaunch.engine.interfaces.registry import underlay_registry
    from edulaunch.extras.network.network_link import Interface, Message

    (folder / 'turtles.launch.py').write_text(TURTLES)
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
    own, side = machine.end()
    peer.close()
    what = f'{link_name}: three turtles with tf'
    return {
        f'{what}, the machine (% of a core)': own * 100,
        f'{what}, its side process (% of a core)': side * 100,
        f'{what}, sent (1/s)': (int(sent_now) - int(sent)) / SECONDS,
        f'{what}, heard out there (1/s)': heard / SECONDS,
    }


def measure(links: Sequence[str]) -> dict[str, float]:
    """All figures, link by link; 'none' is the same machine with the network off."""
    figures: dict[str, float] = {}
    with tempfile.TemporaryDirectory() as folder:
        for link_name in links:
            for part in (three_turtles,) if link_name == 'none' else (round_trips, flood, three_turtles):
                figures |= part(Path(folder), link_name)
    return figures


if __name__ == '__main__':
    edulaunch.source()
    if len(sys.argv) > 1:
        host(sys.argv[2:], sys.argv[1])
    from edulaunch.extras.native import environment

    available = ['none', 'cyclonedds', *(['rclpy'] if environment.found() else [])]
    for name, figure in measure(available).items():
        print(f'{name}: {figure:.4g}')
    print(f'load of this computer meanwhile: {os.getloadavg()[0]:.1f}')
