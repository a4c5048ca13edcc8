"""What a machine does about its own network: on and off, the clock, and mistakes of ours."""

from __future__ import annotations

import io
import selectors
import socket
import time
from collections.abc import Iterator
from typing import Any

import pytest

from edulaunch.engine.sim.pacing import RealTime
from edulaunch.extras.network.crossing import Crossing, JoinRequest
from edulaunch.extras.network.network_link import LinkError, RemoteNode, Settings
from edulaunch.extras.network.switch import MOST_MISTAKES, Switch
from edulaunch.runtime.session import Session
from tests.extras.network.places import Air, MemoryLink


class Wired(MemoryLink):
    """A memory link that can be waited for."""

    def __init__(self, air: Air) -> None:
        super().__init__(air)
        self.ends = {}
        self.pair = socket.socketpair()
        self.is_closed = False

    def fileno(self) -> int:
        return self.pair[0].fileno()

    def close(self) -> None:
        super().close()
        self.is_closed = True
        for end in self.pair:
            end.close()


class Machine:
    """A machine without terminals."""

    def __init__(self, link: Wired, start_ns: int) -> None:
        self.session = Session(start_ns=start_ns)
        self.time = RealTime(self.session.sim)
        self.selector = selectors.DefaultSelector()
        self.switch = Switch(self.session, self.time, self.selector)
        self.said: list[str] = []
        self.link = link

    def heard(self) -> None:
        """What the machine does when the link has something."""
        for key in list(self.selector.get_map().values()):
            key.data(0)

    def close(self) -> None:
        self.switch.off()
        self.selector.close()
        self.session.close()


@pytest.fixture
def machine(monkeypatch: pytest.MonkeyPatch, air: Air) -> Iterator[Any]:
    made: list[Machine] = []

    def make(start_ns: int | None = None) -> Machine:
        link = Wired(air)
        monkeypatch.setattr('edulaunch.extras.network.switch.make_link', lambda name: link)
        made.append(Machine(link, time.time_ns() if start_ns is None else start_ns))
        return made[-1]

    yield make
    for each in made:
        each.close()
        each.link.close()


def test_it_joins_on_the_time_of_the_wall_and_leaves(machine: Any) -> None:
    here = machine(time.time_ns() - 5 * 10**9)
    before_ns = time.time_ns()
    here.switch.on({'ROS_DOMAIN_ID': '7'}, JoinRequest(crossing=Crossing(['/tf'])), here.said.append)
    assert before_ns <= here.session.sim.now_ns <= time.time_ns() and here.time.is_wall
    assert here.switch.status().startswith('network: domain 7 of this computer alone, by memory\ncrossing: /tf; 0 messages sent')
    assert here.switch.off() and here.link.is_closed and not here.time.is_wall and not here.selector.get_map()
    assert here.switch.status() == 'the network is off\n' and not here.switch.off()


@pytest.mark.parametrize(
    ('env', 'told'),
    [
        (
            {'ROS_DOMAIN_ID': '7'},
            'help: check that all terminals have ROS_DOMAIN_ID=7. For nodes on another computer, type ROS_AUTOMATIC',
        ),
        ({'ROS_AUTOMATIC_DISCOVERY_RANGE': 'SUBNET'}, 'Does the network let multicast through?'),
        ({'ROS_STATIC_PEERS': '10.0.0.2'}, 'Do they name this computer in ROS_STATIC_PEERS?'),
        (
            {'ROS_AUTOMATIC_DISCOVERY_RANGE': 'OFF'},
            'help: ROS_AUTOMATIC_DISCOVERY_RANGE is OFF, so this machine does not search for nodes',
        ),
    ],
)
def test_who_finds_nobody_is_told_what_to_look_at_but_not_in_the_first_moment(machine: Any, env: Any, told: str) -> None:
    here = machine()
    here.switch.on(env, JoinRequest(), here.said.append)
    assert 'help: ' not in here.switch.status()
    here.session.sim.run(here.session.sim.now_ns + 4 * 10**9)
    assert told in here.switch.status()
    other = MemoryLink(here.link.air)
    other.open(Settings())
    other.add_node('/', 'real')
    assert 'help: ' not in here.switch.status()


def test_who_launches_with_the_network_is_told_that_it_has_joined_and_left(machine: Any) -> None:
    here = machine()
    leave = here.switch.join({'ROS_DOMAIN_ID': '7'}, (), here.said.append, here.said.append)
    where = 'domain 7 of this computer alone, by memory'
    assert here.said.pop() == f'joined the real ROS 2 network: {where}'
    again = here.switch.join({'ROS_DOMAIN_ID': '7'}, (), here.said.append, here.said.append)
    assert here.said.pop() == f'this machine is already on the real ROS 2 network: {where}'
    here.switch.join({'ROS_DOMAIN_ID': '7'}, ['--topics=/tf'], here.said.append, here.said.append)
    assert ', with other settings than requested here (type edulaunch network off, and launch again): ' in here.said.pop()
    again()
    assert here.said == [] and here.switch.bridge is not None
    leave()
    assert here.said == ['left the real ROS 2 network'] and here.switch.bridge is None
    leave()
    assert len(here.said) == 1


def test_simulated_nodes_of_other_machines_are_told_from_real_ones(machine: Any) -> None:
    here = machine()
    here.switch.on({}, JoinRequest(), here.said.append)
    other = MemoryLink(here.link.air)
    other.open(Settings())
    other.add_node('/', 'real')
    other.nodes[other.add_node('/', 'turtlesim')] = RemoteNode(other.gid, '/', 'turtlesim', True)
    here.heard()
    status = here.switch.status()
    assert 'real nodes: 1 and 1 simulated by other machines, with 0 endpoints\n  /real\n  /turtlesim (simulated)\n' in status


def test_the_time_goes_on_clock_when_asked_for(machine: Any) -> None:
    here = machine()
    here.switch.on({}, JoinRequest(clock=True), here.said.append)
    began_ns = here.session.sim.now_ns
    here.session.sim.run(began_ns + 100_000_000)
    flat = here.session.recorder.columns['/clock', 'rosgraph_msgs/msg/Clock']
    assert flat[2::3] == [divmod(began_ns + tick * 10_000_000, 10**9) for tick in range(11)]
    here.switch.off()
    here.session.sim.run(here.session.sim.now_ns + 100_000_000)
    assert len(flat[2::3]) == 11 and here.session.graph.nodes == []


def test_mistakes_of_ours_do_not_end_the_machine(machine: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    here = machine()
    here.switch.on({}, JoinRequest(), here.said.append)
    monkeypatch.setattr(here.link, 'take', lambda: 1 / 0)
    monkeypatch.setattr('sys.__stderr__', io.StringIO())
    for _ in range(MOST_MISTAKES - 1):
        here.heard()
    assert here.switch.bridge is not None and here.said == []
    here.heard()
    assert here.switch.bridge is None and here.link.is_closed
    assert here.said == ['the network is off, because edulaunch failed on messages from it; see the log of the machine']


def test_a_link_that_cannot_be_opened_leaves_nothing_behind(machine: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    here = machine()

    def refuse(settings: Settings) -> None:
        raise LinkError('no cable', help='plug it in')

    monkeypatch.setattr(here.link, 'open', refuse)
    assert here.switch.run(['on'], {}, here.said.append, here.said.append) == 1
    assert here.said == ['error: no cable\n  help: plug it in\n']
    assert here.link.is_closed and not here.time.is_wall and not here.selector.get_map()


def test_a_machine_whose_clock_is_not_the_walls_does_not_join(machine: Any) -> None:
    for start_ns in (1_700_000_000_000_000_000, time.time_ns() + 60 * 10**9):
        here = machine(start_ns)
        assert here.switch.run(['on'], {}, here.said.append, here.said.append) == 1
        assert here.said == [
            'error: this machine does not run in real time\n  help: type edulaunch machine stop, and start again\n'
        ]
