"""A node on the real rclpy that does not run for a while, as on a busy computer, loses nothing that was published reliably meanwhile."""

from __future__ import annotations

import json
import os
import select
import signal
import subprocess
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from edulaunch.engine.graph.qos import QoS
from edulaunch.extras.native import environment
from edulaunch.extras.network.links import make_link
from edulaunch.extras.network.network_link import PUBLISHER, Link, Settings
from tests.extras.network.places import STRING, text
from tests.extras.network.two_computers import interface
from tests.extras.network.wires import LIMIT_S

pytestmark = pytest.mark.real
COUNT = 900
SUBSCRIBER = """
import json, rclpy
from std_msgs.msg import String

rclpy.init()
node, heard = rclpy.create_node('subscriber'), []

def hear(message):
    if message.data == 'end':
        print(json.dumps(heard), flush=True)
    elif message.data == 'begin':
        print('begun', flush=True)
    else:
        heard.append(int(message.data))

node.create_subscription(String, '/numbers', hear, 2000)
rclpy.spin(node)
"""


class Subscriber:
    """The real node, and what it prints."""

    def __init__(self, python: str, domain: int) -> None:
        env = {name: value for name, value in os.environ.items() if not name.startswith(('PYTHON', 'ROS_', 'AMENT_'))}
        env.update(ROS_DOMAIN_ID=str(domain), ROS_AUTOMATIC_DISCOVERY_RANGE='LOCALHOST')
        self.program = subprocess.Popen([python, '-c', SUBSCRIBER], env=env, stdout=subprocess.PIPE)
        assert self.program.stdout is not None
        os.set_blocking(self.program.stdout.fileno(), False)
        self._text = b''

    def lines(self) -> list[str]:
        """Everything that it has printed."""
        assert self.program.stdout is not None
        self._text += self.program.stdout.read() or b''
        return self._text.decode().splitlines()

    def is_stopped(self) -> bool:
        return Path(f'/proc/{self.program.pid}/stat').read_text().rpartition(')')[2].split()[0] == 'T'


@pytest.fixture
def subscriber(domain: int) -> Iterator[Subscriber]:
    found = environment.found()
    if found is None:
        pytest.skip('the real rclpy is not installed: edulaunch network install')
    made = Subscriber(found.python, domain)
    yield made
    made.program.kill()
    made.program.communicate()


def until(link: Link, condition: Callable[[], object], each: Callable[[], object] = lambda: None) -> None:
    """Serve the link until something is so."""
    end_s = time.monotonic() + LIMIT_S
    while not condition():
        assert time.monotonic() < end_s, 'it never came'
        link.flush()
        if select.select([link], [], [], 0.02)[0]:
            link.take()
        each()


@pytest.mark.parametrize('kind', ['cyclonedds', 'rclpy'])
def test_it_hears_all_that_was_said_meanwhile(kind: str, subscriber: Subscriber, domain: int) -> None:
    """A depth of ten, nine hundred messages: more than wait in shared memory (512), as many as a publisher keeps."""
    link = make_link(kind)
    link.open(Settings(domain))
    try:
        node = link.add_node('/', 'publisher')
        end = link.add(node, PUBLISHER, '/numbers', interface(STRING), QoS(depth=10))
        until(link, lambda: 'begun' in subscriber.lines(), lambda: link.publish(end, text('begin')))
        subscriber.program.send_signal(signal.SIGSTOP)
        until(link, subscriber.is_stopped)
        for number in range(COUNT):
            link.publish(end, text(str(number)))
            link.flush()
        until(link, lambda: True)
        subscriber.program.send_signal(signal.SIGCONT)
        link.publish(end, text('end'))
        until(link, lambda: subscriber.lines()[-1] != 'begun')
        assert json.loads(subscriber.lines()[-1]) == list(range(COUNT))
    finally:
        link.close()
