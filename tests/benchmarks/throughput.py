"""What arrives from a machine at a node on the real rclpy: images of 1 MB, and twenty topics at 200 messages a second.

`python -m tests.benchmarks.throughput` needs `edulaunch[network]` and `edulaunch network install`. It measures each row for both links,
and for two nodes on the real rclpy in the same run. All programs are on the loopback. The subscriber's queue is 1000 deep: a
queue of ten loses messages between two real nodes, too.
"""

from __future__ import annotations

import os
import select
import subprocess
import time
from collections.abc import Callable
from typing import Any

import edulaunch

DOMAIN = 102
SECONDS = 6.0
SUBSCRIBER = """
import sys, time, rclpy
from rclpy.qos import QoSProfile, ReliabilityPolicy
from std_msgs.msg import String

topics, reliable, seconds = int(sys.argv[1]), sys.argv[2] == 'reliable', float(sys.argv[3])
rclpy.init()
node, late = rclpy.create_node('subscriber'), []
reliability = ReliabilityPolicy.RELIABLE if reliable else ReliabilityPolicy.BEST_EFFORT

def heard(message):
    late.append(time.time() - float(message.data[:20]))

for number in range(topics):
    node.create_subscription(String, f'/topic{number}', heard, QoSProfile(depth=1000, reliability=reliability))
end = time.monotonic() + seconds
while time.monotonic() < end:
    rclpy.spin_once(node, timeout_sec=0.1)
late.sort()
print(len(late), *(f'{late[len(late) * part // 100] * 1000:.1f}' if late else '-' for part in (50, 99)))
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
began, body = time.monotonic(), 'x' * int(size)
for number in range(int(rate * seconds)):
    for publisher in publishers:
        publisher.publish(String(data=f'{time.time():<20}' + body))
    time.sleep(max(0, began + (number + 1) / rate - time.monotonic()))
time.sleep(2)
"""


def real_python() -> str:
    """The Python of the real rclpy."""
    from edulaunch.extras.native.environment import needed

    return needed().python


def environment() -> dict[str, str]:
    """Both sides are on this computer alone. In an active terminal PYTHONPATH leads to the simulated rclpy."""
    own = {name: value for name, value in os.environ.items() if name != 'PYTHONPATH'}
    return {**own, 'ROS_DOMAIN_ID': str(DOMAIN), 'ROS_AUTOMATIC_DISCOVERY_RANGE': 'LOCALHOST'}


def measured(publish: Callable[[], object], topics: int, reliability: str) -> str:
    """How many messages a real subscriber got, and how late they were (median and 99 of 100, ms)."""
    words = [real_python(), '-c', SUBSCRIBER, str(topics), reliability, str(SECONDS + 6)]
    subscriber = subprocess.Popen(words, stdout=subprocess.PIPE, text=True, env=environment())
    publish()
    return subscriber.communicate()[0].strip()


def by_link(kind: str, topics: int, reliability: str, size: int, rate: float) -> None:
    """Publish through a link."""
    from edulaunch.engine.graph.qos import BEST_EFFORT, RELIABLE, QoS
    from edulaunch.engine.interfaces.registry import underlay_registry
    from edulaunch.extras.network.links import make_link
    from edulaunch.extras.network.network_link import PUBLISHER as KIND
    from edulaunch.extras.network.network_link import Interface, Settings
    from edulaunch.ros.serialization.cdr import encode

    cls, link = underlay_registry().get('std_msgs/msg/String'), make_link(kind)
    link.open(Settings(DOMAIN))
    node = link.add_node('/', 'publisher')
    qos = QoS(depth=10, reliability=RELIABLE if reliability == 'reliable' else BEST_EFFORT)
    interface = Interface('std_msgs/msg/String', underlay_registry())
    ends = [link.add(node, KIND, f'/topic{number}', interface, qos) for number in range(topics)]
    serve(link, 3.0)
    began, body = time.monotonic(), 'x' * size
    for number in range(int(rate * SECONDS)):
        for end in ends:
            link.publish(end, encode(cls, (f'{time.time():<20}' + body,)))
        serve(link, began + (number + 1) / rate - time.monotonic())
    serve(link, 2.0)
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


def main() -> None:
    """Print a row for each way."""
    edulaunch.source()
    for title, topics, size, rate in (('images of 1 MB at 10 Hz', 1, 1_000_000, 10.0), ('20 topics at 200 Hz', 20, 100, 200.0)):
        for reliability in ('reliable', 'best effort'):
            print(f'{title}, {reliability}, {int(topics * rate * SECONDS)} sent: heard, median and 99 of 100 in ms')
            words = [real_python(), '-c', PUBLISHER, str(topics), reliability, str(SECONDS), str(size), str(rate)]
            print(
                '  two real nodes:', measured(lambda words=words: subprocess.run(words, env=environment()), topics, reliability)
            )  # type: ignore[misc]
            for kind in ('cyclonedds', 'rclpy'):
                row = (kind, topics, reliability, size, rate)
                print(f'  {kind}:', measured(lambda row=row: by_link(*row), topics, reliability))  # type: ignore[misc]


if __name__ == '__main__':
    main()
