"""What arrives from a machine at a node on the real rclpy: images of 1 MB, and twenty topics at 200 messages a second.

`python -m tests.benchmarks.throughput [BUSY [ROUNDS]]` needs `edulaunch[network]` and `edulaunch network install`. It measures each row for two
nodes on the real rclpy and for both links, in turns, so often as ROUNDS says, while BUSY other programs compute. All is on the loopback. The
subscriber's queue is 1000 deep: a queue of ten loses messages between two real nodes, too. All wait until it has heard nothing for a while:
what is late is not lost. In the middle, a new publisher begins: the last figure says how long it took until the subscriber heard it.
"""

from __future__ import annotations

import os
import select
import subprocess
import sys
import time
from collections.abc import Callable
from contextlib import ExitStack
from typing import Any

import edulaunch

DOMAIN = 102
SECONDS = 6.0
SUBSCRIBER = """
import sys, time, rclpy
from rclpy.qos import QoSProfile, ReliabilityPolicy
from std_msgs.msg import String

topics, reliable, quiet = int(sys.argv[1]), sys.argv[2] == 'reliable', float(sys.argv[3])
rclpy.init()
node, late, new, stamps = rclpy.create_node('subscriber'), [], [], []
reliability = ReliabilityPolicy.RELIABLE if reliable else ReliabilityPolicy.BEST_EFFORT

def heard(message):
    stamps.append(float(message.data[:20]))
    late.append(time.time() - stamps[-1])

for number in range(topics):
    node.create_subscription(String, f'/topic{number}', heard, QoSProfile(depth=2000, reliability=reliability))
node.create_subscription(String, '/new', lambda message: new or new.append(time.time() - float(message.data)), 10)
end, count = time.monotonic() + 60, 0
while time.monotonic() < end:
    rclpy.spin_once(node, timeout_sec=0.1)
    if len(late) > count:
        count, end = len(late), time.monotonic() + quiet
late.sort()
figures = [*(late[len(late) * part // 100] * 1000 for part in (50, 99) if late), *(each * 1000 for each in new)]
print(f'{len(late):6d}', *(f'{figure:9.1f}' for figure in figures), f'{max(stamps) - min(stamps):5.1f} s, cpu {time.process_time():.1f} s')
"""
PUBLISHER = """
import sys, time, rclpy
from rclpy.qos import QoSProfile, ReliabilityPolicy
from std_msgs.msg import String

topics, reliable, seconds, size, rate = int(sys.argv[1]), sys.argv[2] == 'reliable', *map(float, sys.argv[3:])
rclpy.init()
node = rclpy.create_node('publisher')
reliability = ReliabilityPolicy.RELIABLE if reliable else ReliabilityPolicy.BEST_EFFORT
publishers = [node.create_publisher(String, f'/topic{n}', QoSProfile(depth=10, reliability=reliability)) for n in range(topics)]
time.sleep(3)
began, body, new, since = time.monotonic(), 'x' * int(size), None, 0
for number in range(int(rate * seconds)):
    for publisher in publishers:
        publisher.publish(String(data=f'{time.time():<20}' + body))
    if number * 2 == int(rate * seconds):
        since, new = time.time(), node.create_publisher(String, '/new', 10)
    if new:
        new.publish(String(data=f'{since:<20}'))
    time.sleep(max(0, began + (number + 1) / rate - time.monotonic()))
sys.stdin.read()
"""
BUSY = 'while True: pass'


def real_python() -> str:
    """The Python of the real rclpy."""
    from edulaunch.extras.native.environment import needed

    return needed().python


def environment() -> dict[str, str]:
    """Both sides are on this computer alone. In an active terminal PYTHONPATH leads to the simulated rclpy."""
    own = {name: value for name, value in os.environ.items() if name != 'PYTHONPATH'}
    return {**own, 'ROS_DOMAIN_ID': str(DOMAIN), 'ROS_AUTOMATIC_DISCOVERY_RANGE': 'LOCALHOST'}


Row = tuple[int, str, int, float]
"""How many topics, their reliability, bytes of a message, messages a second."""


def measured(publish: Callable[[Row, subprocess.Popen[str]], object], row: Row) -> str:
    """How many messages a real subscriber got, how late they were (median and 99 of 100, ms), and how late a new topic was."""
    words = [real_python(), '-c', SUBSCRIBER, str(row[0]), row[1], '3']
    subscriber = subprocess.Popen(words, stdout=subprocess.PIPE, text=True, env=environment())
    publish(row, subscriber)
    return subscriber.communicate()[0].rstrip()


def by_real_node(row: Row, subscriber: subprocess.Popen[str]) -> None:
    """Publish by a node on the real rclpy."""
    topics, reliability, size, rate = row
    words = [real_python(), '-c', PUBLISHER, str(topics), reliability, str(SECONDS), str(size), str(rate)]
    with subprocess.Popen(words, stdin=subprocess.PIPE, env=environment()):
        subscriber.wait()


def by_link(kind: str, row: Row, subscriber: subprocess.Popen[str]) -> None:
    """Publish through a link."""
    from edulaunch.engine.graph.qos import BEST_EFFORT, RELIABLE, QoS
    from edulaunch.engine.interfaces.registry import underlay_registry
    from edulaunch.extras.network.links import make_link
    from edulaunch.extras.network.network_link import PUBLISHER as KIND
    from edulaunch.extras.network.network_link import Interface, Settings
    from edulaunch.ros.serialization.cdr import encode

    topics, reliability, size, rate = row
    cls, link = underlay_registry().get('std_msgs/msg/String'), make_link(kind)
    link.open(Settings(DOMAIN))
    node = link.add_node('/', 'publisher')
    qos = QoS(depth=10, reliability=RELIABLE if reliability == 'reliable' else BEST_EFFORT)
    interface = Interface('std_msgs/msg/String', underlay_registry())
    ends = [link.add(node, KIND, f'/topic{number}', interface, qos) for number in range(topics)]
    serve(link, 3.0)
    began, body, new, since = time.monotonic(), 'x' * size, 0, 0.0
    for number in range(int(rate * SECONDS)):
        for end in ends:
            link.publish(end, encode(cls, (f'{time.time():<20}' + body,)))
        if number * 2 == int(rate * SECONDS):
            since, new = time.time(), link.add(node, KIND, '/new', interface, QoS())
        if new:
            link.publish(new, encode(cls, (f'{since:<20}',)))
        serve(link, began + (number + 1) / rate - time.monotonic())
    while subscriber.poll() is None:
        serve(link, 0.1)
    link.close()


def serve(link: Any, seconds: float) -> None:
    """Let the link work for so long, as a machine does between its turns."""
    end = time.monotonic() + seconds
    while True:
        link.flush()
        left = end - time.monotonic()
        if left <= 0:
            return
        if select.select([link], [], [], min(left, 0.01))[0]:
            link.take()


def main(busy: int, rounds: int) -> None:
    """Print a row for each way."""
    edulaunch.source()
    ways: dict[str, Callable[[Row, subprocess.Popen[str]], object]] = {
        'two real nodes': by_real_node,
        'cyclonedds': lambda *given: by_link('cyclonedds', *given),
        'rclpy': lambda *given: by_link('rclpy', *given),
    }
    with ExitStack() as others:
        for _ in range(busy):
            other = subprocess.Popen([sys.executable, '-c', BUSY])
            others.callback(other.wait)
            others.callback(other.kill)
        for title, topics, size, rate in (
            ('images of 1 MB at 10 Hz', 1, 1_000_000, 10.0),
            ('20 topics at 200 Hz', 20, 100, 200.0),
        ):
            for reliability in ('reliable', 'best effort'):
                print(f'{title}, {reliability}, {int(topics * rate * SECONDS)} sent: heard, median, 99 of 100, a new topic (ms)')
                for _ in range(rounds):
                    for name, way in ways.items():
                        print(
                            f'  {name:15} {measured(way, (topics, reliability, size, rate))}  load {os.getloadavg()[0]:.1f}',
                            flush=True,
                        )


if __name__ == '__main__':
    main(*(int(word) for word in sys.argv[1:]), *(0, 1)[len(sys.argv) - 1 :])
