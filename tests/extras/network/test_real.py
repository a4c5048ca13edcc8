"""Machines and a node on the real rclpy (Fast DDS), on the loopback."""

from __future__ import annotations

import json
import os
import subprocess
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from edulaunch.engine.graph.qos import BEST_EFFORT, TRANSIENT_LOCAL, QoS
from edulaunch.engine.interfaces.registry import underlay_registry
from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.extras.native import environment
from edulaunch.ros.serialization.type_description import type_hash
from tests.extras.network.places import STRING

pytestmark = pytest.mark.real
PEER = str(Path(__file__).with_name('real_peer.py'))


class Peer:
    """The real node, and what it has told so far."""

    def __init__(self, python: str, domain: int, *words: str) -> None:
        env = {name: value for name, value in os.environ.items() if not name.startswith(('PYTHON', 'ROS_', 'AMENT_'))}
        env.update(ROS_DOMAIN_ID=str(domain), ROS_AUTOMATIC_DISCOVERY_RANGE='LOCALHOST')
        pipe = subprocess.PIPE
        self.program = subprocess.Popen([python, PEER, *words], env=env, stdin=pipe, stdout=pipe)
        assert self.program.stdout is not None
        os.set_blocking(self.program.stdout.fileno(), False)
        self._text = ''
        self.said: list[Any] = []

    def read(self) -> None:
        """Take what it has told."""
        assert self.program.stdout is not None
        self._text += (self.program.stdout.read() or b'').decode()
        *lines, self._text = self._text.split('\n')
        self.said += [json.loads(line) for line in lines]

    def last(self, what: str) -> Any:
        """What it told of something last."""
        return next((line[1:] for line in reversed(self.said) if line[0] == what), None)

    def kill(self) -> None:
        self.program.kill()
        self.program.communicate()


@pytest.fixture
def peer(domain: int) -> Iterator[Callable[..., Peer]]:
    """Starts real nodes."""
    found = environment.found()
    if found is None:
        pytest.skip('the real rclpy is not installed: edulaunch network install')
    if subprocess.run([found.python, '-c', 'import std_msgs, std_srvs'], capture_output=True, check=False).returncode:
        pytest.skip(f'pip --python {found.python} install ros-jazzy-std-msgs ros-jazzy-std-srvs')
    made: list[Peer] = []

    def start(*words: str) -> Peer:
        made.append(Peer(found.python, domain, *words))
        return made[-1]

    yield start
    for each in made:
        each.kill()


def test_topics_cross_both_ways_and_each_sees_the_other(wire: Any, peer: Any) -> None:
    here, real = wire.place('sim'), peer('say=/down,hello', 'hear=/up', 'look=/up')
    up = here.publisher('/up')
    here.subscription('/down')

    def each() -> None:
        up.publish(('salute',))
        real.read()

    wire.until(lambda: here.heard and real.last('heard'), each)
    assert here.heard[0] == ('hello',) and real.last('heard') == ['salute']
    wire.until(lambda: (real.last('sees') or [[]])[0] == ['/lab/real_peer', '/sim'] and len(real.last('sees')[1]) == 2, each)
    text_hash = 'TypeHash(version=1, value='
    rows = {row[0]: row for row in real.last('sees')[1]}
    assert rows['PUBLISHER'][1:3] == ['sim', STRING] and rows['PUBLISHER'][3] == rows['SUBSCRIPTION'][3] != text_hash
    wire.until(lambda: '/lab/real_peer' in here.nodes() and '/down' in here.graph.publishers, each)
    [mirrored] = here.graph.publishers['/down']
    assert (mirrored.node.name, mirrored.type_name) == ('real_peer', STRING)
    remote = {end.name: end for end in here.link.graph().endpoints}
    assert remote['/down'].hash == type_hash(STRING, underlay_registry().spec)


def test_what_stays_reaches_a_late_joiner_and_the_log_crosses(wire: Any, peer: Any) -> None:
    here = wire.place('sim')
    here.publisher('/map', qos=QoS(depth=1, durability=TRANSIENT_LOCAL)).publish(('the map',))
    spec = ProcessSpec(argv=('ros2', 'run', 'demo_nodes_py', 'talker'), name='talker', env=dict(here.session.host.env))
    here.session.host.start(spec)
    real = peer('hear=/map,stays', 'hear_log=')
    wire.until(lambda: real.last('heard') and real.last('log'), real.read)
    assert real.last('heard') == ['the map']
    assert real.last('log')[0] == 'talker' and real.last('log')[1].startswith('Publishing: "Hello World:')


def test_what_cannot_match_is_told_on_both_sides(wire: Any, peer: Any) -> None:
    here, policies = wire.place('sim'), []
    here.subscription('/a').on_incompatible = policies.append
    here.publisher('/b', qos=QoS(reliability=BEST_EFFORT)).on_incompatible = policies.append
    real = peer('hear_loosely=/a', 'hear_strictly=/b')
    wire.until(lambda: len(policies) == 2 and len([line for line in real.said if line[0] == 'incompatible']) == 2, real.read)
    assert policies == ['RELIABILITY'] * 2 and real.last('incompatible') == ['RMW_QOS_POLICY_RELIABILITY']


def test_a_service_that_could_not_answer_fast_dds_is_not_seen_and_that_is_said(wire: Any, peer: Any) -> None:
    here = wire.place('sim')
    here.service('/reset')
    real = peer('want=/reset')
    wire.until(lambda: here.said and real.last('ready') is not None, real.read)
    assert real.last('ready') == [False]
    assert here.said == [
        'a real node has a client of the service /reset: its calls do not cross\n'
        '  help: only topics cross to Fast DDS here; for all: edulaunch network install, then edulaunch network on --link rclpy'
    ]


def test_bytes_that_are_no_message_do_no_harm(wire: Any, peer: Any) -> None:
    bad = ['', '0001', '00010000', '00010000ffffff7f', '0001000004000000ffffffff', '00000000' + '00' * 5]
    here, evil, good = wire.place('sim'), peer(','.join(['raw=/chatter', *bad])), peer('say=/chatter,good')
    here.subscription('/chatter')
    wire.until(
        lambda: evil.said and good.said and len(here.graph.publishers.get('/chatter', ())) == 2,
        lambda: (evil.read(), good.read()),
    )
    here.heard.clear()
    wire.until(lambda: here.heard.count(('good',)) > 20)
    assert set(here.heard) <= {('good',), ('',)}


def test_a_peer_that_is_killed_leaves_and_another_is_heard(wire: Any, peer: Any) -> None:
    here, first = wire.place('sim'), peer('say=/chatter,first')
    here.subscription('/chatter')
    wire.until(lambda: ('first',) in here.heard)
    first.kill()
    peer('say=/chatter,second')
    wire.until(lambda: ('second',) in here.heard)
    wire.until(lambda: len(here.graph.publishers['/chatter']) == 1)


def test_every_image_of_a_reliable_publisher_arrives(wire: Any, peer: Any) -> None:
    """One megabyte, ten times a second, as from a camera."""
    here, real = wire.place('sim'), peer('count=/image')
    image = here.publisher('/image')
    wire.until(lambda: image.subscription_count, real.read)
    due = time.monotonic()
    sent = 0

    def publish() -> None:
        nonlocal sent, due
        real.read()
        heard = (real.last('count') or [0])[0]
        if sent < 20 and time.monotonic() >= due and sent - heard < 5:  # ten more would fall out of the publisher's history
            image.publish(('x' * 1_000_000,))
            sent, due = sent + 1, time.monotonic() + 0.1

    wire.until(lambda: real.last('count') == [20], publish)
    assert not here.said
