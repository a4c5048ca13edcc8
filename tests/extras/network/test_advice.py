"""What the doctor says of a network, from the facts that a bridge leaves in the record."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

from edulaunch.advice import judge, rendered
from edulaunch.advice.reader import Reader
from edulaunch.engine.graph.qos import BEST_EFFORT, QoS
from edulaunch.engine.interfaces.registry import underlay_registry
from edulaunch.extras.network.crossing import JoinRequest
from edulaunch.extras.network.network_link import Interface, Settings
from edulaunch.extras.network.switch import ALONE_NS
from tests.extras.network.places import PUBLISHER, STRING, TRIGGER, Air, MemoryLink, Place, cls_of, text, turns
from tests.extras.network.test_mistakes import machine as machine

UNDERLAY = Interface(STRING, underlay_registry())


def findings(place: Any) -> list[tuple[str, str]]:
    return [(found.rule, rendered(found, Reader()).what) for found in judge(place.session.snapshot())]


def real(air: Air, here: Place, name: str = 'real', qos: QoS = QoS(), type_hash: str | None = None) -> tuple[MemoryLink, int]:
    """A real node that talks on /chatter, to a node here."""
    link = MemoryLink(air)
    link.open(Settings())
    mouth = link.add(link.add_node('/', name), PUBLISHER, '/chatter', UNDERLAY, qos)
    if type_hash is not None:
        link.ends[mouth] = link.ends[mouth]._replace(hash=type_hash)
    turns(here)
    here.subscription('/chatter')
    turns(here)
    here.sim.run(here.sim.now_ns + 1)
    return link, mouth


def test_a_real_node_that_fits_is_nothing_to_speak_of(place: Any, air: Air) -> None:
    here = place('a')
    link, mouth = real(air, here)
    link.publish(mouth, text('here'))
    turns(here)
    assert findings(here) == []


def test_a_quality_of_service_that_does_not_fit_a_real_publisher(place: Any, air: Air) -> None:
    here = place('a')
    real(air, here, qos=QoS(reliability=BEST_EFFORT))
    assert [rule for rule, _ in findings(here)] == ['messages.best-effort']


def test_a_real_node_of_the_same_name(place: Any, air: Air) -> None:
    here = place('a')
    real(air, here, name='a')
    assert [rule for rule, _ in findings(here)] == ['programs.same-name']


def test_another_definition(place: Any, air: Air) -> None:
    here = place('a')
    real(air, here, type_hash='RIHS01_' + '0' * 64)
    wanted = 'std_msgs/msg/String has a different definition on the other computer, so its messages are misread or dropped'
    assert findings(here) == [('messages.other-definition', wanted)]


def test_another_time(place: Any, air: Air) -> None:
    here = place('a', wall_ns=lambda: 100 * 10**9)
    link, mouth = real(air, here)
    air.now = 110 * 10**9
    link.publish(mouth, text('here'))
    turns(here)
    assert findings(here) == [
        ('time.other-clock', 'the clock of the computer that runs /real differs from the clock of this computer')
    ]


def test_nobody_is_there_until_somebody_comes(machine: Any) -> None:
    here = machine()
    graph = here.session.graph
    own = graph.add_node(SimpleNamespace(name='own', pid=1, state={}), 'own', '/')
    graph.create_service(own, '/reset', cls_of(TRIGGER), QoS(), lambda: None)  # the bridge asks it in the name of a hidden node
    here.switch.on({'ROS_DOMAIN_ID': '7'}, JoinRequest(), here.said.append)
    assert findings(here) == []
    here.session.sim.run(here.session.sim.now_ns + ALONE_NS)
    told_first = 'this machine found no other computer in domain 7 of the network (discovery range: LOCALHOST)'
    assert findings(here) == [('programs.alone-on-network', told_first)]
    other = MemoryLink(here.link.air)
    other.open(Settings())
    other.add_node('/', 'real')
    here.heard()
    assert findings(here) == []
