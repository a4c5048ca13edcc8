"""A bridge, on a network in memory: what crosses, and what must not."""

from __future__ import annotations

from typing import Any

import pytest

from edulaunch.engine.graph.qos import BEST_EFFORT, TRANSIENT_LOCAL, QoS
from edulaunch.engine.interfaces.registry import underlay_registry
from edulaunch.extras.network.crossing import Crossing
from edulaunch.extras.network.network_link import Interface, RemoteEndpoint, RemoteNode, Settings
from edulaunch.extras.network.remote import named
from tests.extras.network.places import PUBLISHER, STRING, Air, MemoryLink, cls_of, text, turns

UNDERLAY = Interface(STRING, underlay_registry())


def raw(air: Air, name: str = 'real') -> tuple[MemoryLink, int]:
    """Somebody on the network who is no machine of ours, with a node."""
    link = MemoryLink(air)
    link.open(Settings())
    return link, link.add_node('/', name)


def test_a_message_crosses_once_and_is_recorded_on_both_sides(place: Any) -> None:
    here, there = place('a'), place('b')
    publisher, _ = here.publisher('/chatter'), there.subscription('/chatter')
    turns(here, there)
    publisher.publish(('hello',))
    turns(here, there)
    assert there.heard == [('hello',)]
    for each in (here, there):
        assert each.session.recorder.columns['/chatter', STRING][2::3] == [('hello',)]
    assert (here.bridge.sent, there.bridge.received) == (1, 1)


def test_nothing_is_sent_while_nobody_out_there_listens(place: Any) -> None:
    here, there = place('a'), place('b')
    publisher = here.publisher('/chatter')
    here.subscription('/chatter')
    turns(here, there)
    publisher.publish(('hello',))
    turns(here, there)
    assert here.link.published == [] and here.heard == [('hello',)]


def test_nobody_hears_himself_and_two_bridges_are_no_loop(place: Any, air: Air) -> None:
    here, there = place('a'), place('b')
    real, node = raw(air)
    ear = real.add(node, 'subscription', '/chatter', UNDERLAY, QoS())
    publishers = [each.publisher('/chatter') for each in (here, there)]
    for each in (here, there):
        each.subscription('/chatter')
    turns(here, there)
    publishers[0].publish(('hello',))
    turns(here, there)
    assert here.heard == there.heard == [('hello',)]
    assert [event.handle for event in real.take() if hasattr(event, 'cdr')] == [ear]


def test_several_subscriptions_of_a_machine_get_one_message_each_and_the_record_one(place: Any) -> None:
    here, there = place('a'), place('b')
    publisher = here.publisher('/chatter')
    for _ in range(3):
        there.subscription('/chatter')
    turns(here, there)
    publisher.publish(('hello',))
    turns(here, there)
    assert there.heard == [('hello',)] * 3
    assert len(there.session.recorder.columns['/chatter', STRING]) == 3


def test_what_was_published_before_the_bridge_came_waits_for_late_joiners(place: Any, air: Air) -> None:
    here = place('a')
    here.bridge.close()
    publisher = here.publisher('/map', qos=QoS(depth=2, durability=TRANSIENT_LOCAL))
    for words in ('one', 'two', 'three'):
        publisher.publish((words,))
    again = MemoryLink(air)
    here.bridge = type(here.bridge)(here.session, again, tell=here.said.append)
    here.bridge.open(Settings())
    assert again.published == [text('two'), text('three')]


def test_real_nodes_and_endpoints_are_seen_as_if_they_ran_here_and_go_again(place: Any, air: Air) -> None:
    here = place('a')
    real, node = raw(air, 'lidar')
    qos = QoS(reliability=BEST_EFFORT)
    end = real.add(node, PUBLISHER, '/scan', Interface('sensor_msgs/msg/LaserScan', UNDERLAY.registry), qos)
    turns(here)
    assert here.nodes() == ['/a', '/lidar']
    [mirrored] = here.graph.publishers['/scan']
    assert (mirrored.type_name, mirrored.qos.reliability, mirrored.node.name) == (
        'sensor_msgs/msg/LaserScan',
        BEST_EFFORT,
        'lidar',
    )
    real.remove(end)
    real.remove_node(node)
    turns(here)
    assert here.nodes() == ['/a'] and '/scan' not in here.graph.publishers


def test_what_was_mirrored_is_not_shown_to_the_network_again(place: Any, air: Air) -> None:
    here = place('a')
    real, node = raw(air)
    real.add(node, PUBLISHER, '/scan', UNDERLAY, QoS())
    turns(here)
    assert [end.name for end in here.link.ends.values()] == [] and [node.name for node in here.link.nodes.values()] == ['a']


def test_a_type_that_nobody_here_has_is_named_and_becomes_usable_with_the_first_who_has_it(place: Any, air: Air) -> None:
    here = place('a')
    real, node = raw(air)
    real.add(node, PUBLISHER, '/odd', Interface(STRING, UNDERLAY.registry), QoS())
    [handle] = real.ends
    real.ends[handle] = real.ends[handle]._replace(type_name='robot_msgs/msg/Odd', hash='')
    turns(here)
    [mirrored] = here.graph.publishers['/odd']
    assert mirrored.type_name == 'robot_msgs/msg/Odd' and not hasattr(mirrored.cls, 'LAYOUT')

    class Odd(cls_of(STRING)):  # type: ignore[misc]
        TYPE = 'robot_msgs/msg/Odd'

    here.bridge._show_own = lambda: here.bridge.mirror.retype()
    here.graph.create_subscription(here.node, '/odd', Odd, QoS(), lambda: None)
    turns(here)
    assert here.graph.publishers['/odd'][0].cls is Odd


def test_names_that_clash_are_told_once(place: Any) -> None:
    here, there = place('same'), place('same')
    turns(here, there, count=9)
    assert len(here.said) == len(there.said) == 1
    assert here.said[0].startswith('two nodes have the name /same: one of this machine, and a real one')


def test_bytes_that_are_no_message_are_dropped_and_told_and_the_next_ones_heard(place: Any, air: Air) -> None:
    here = place('a')
    real, node = raw(air)
    mouth = real.add(node, PUBLISHER, '/chatter', UNDERLAY, QoS())
    here.subscription('/chatter')
    turns(here)
    for bad in (b'', b'\0\1', b'\0\1\0\0', b'\0\1\0\0\xff\xff\xff\xff', b'\0\0\0\0\0\0\0\1a', b'\0\1\0\0\2\0\0\0\xff\0'):
        real.publish(mouth, bad)
        turns(here)
    assert here.heard == []
    real.publish(mouth, text('good'))
    turns(here)
    assert here.heard == [('good',)]
    assert len(here.said) == 1 and '/chatter: dropped, these' in here.said[0]
    assert here.bridge.diagnostics.lines()[0].endswith('(6 times)')


def test_names_that_are_none_are_not_shown(place: Any, air: Air) -> None:
    here = place('a')
    real, node = raw(air)
    end = RemoteEndpoint(b'x' * 16, PUBLISHER, '/a b', STRING, '', QoS(), RemoteNode(real.gid, '/', 'real'))
    real.ends[77] = end
    real.nodes[78] = RemoteNode(real.gid, 'nowhere', '\x1b[2J')
    turns(here)
    assert here.nodes() == ['/a', '/real'] and list(here.graph.publishers) == []
    assert len(here.said) == 2 and '\\x1b' in here.said[0]


def test_an_endpoint_that_nobody_claims_is_shown_a_second_later_or_when_it_speaks(place: Any, air: Air) -> None:
    here = place('a')
    real, node = raw(air)
    for topic in ('/quiet', '/loud'):
        handle = real.add(node, PUBLISHER, topic, UNDERLAY, QoS())
        real.ends[handle] = real.ends[handle]._replace(node=None)
    here.subscription('/loud')
    turns(here)
    assert list(here.graph.publishers) == []
    real.publish(handle, text('hello'))
    turns(here)
    assert here.heard == [('hello',)] and list(here.graph.publishers) == ['/loud']
    here.sim.run(here.sim.now_ns + 10**9)
    turns(here)
    assert list(here.graph.publishers) == ['/loud', '/quiet'] and here.nodes() == ['/a', '/real']
    assert here.graph.publishers['/quiet'][0].node.name == '_NODE_NAME_UNKNOWN_'


def test_a_service_of_another_machine_answers(place: Any) -> None:
    here, there = place('a'), place('b')
    there.service('/reset')
    client = here.client('/reset')
    turns(here, there)
    assert client.server_is_ready()
    numbers = [client.send(()), client.send(())]
    turns(here, there)
    assert there.asked == [(), ()]
    assert [client.take(), client.take(), client.take()] == [(numbers[0], (True, 'done')), (numbers[1], (True, 'done')), None]
    assert [row[5:] for row in here.session.recorder.calls] == [
        [True, row[6], (True, 'done')] for row in here.session.recorder.calls
    ]


def test_two_servers_of_one_name_get_one_request_each_and_the_first_reply_counts(place: Any) -> None:
    here, first, second = place('a'), place('b'), place('c')
    client = here.client('/reset')
    first.service('/reset')
    second.service('/reset', answer=(False, 'late'))
    turns(here, first, second)
    number = client.send(())
    turns(here, first, second)
    assert (first.asked, second.asked) == ([()], [()])
    assert (client.take(), client.take()) == ((number, (True, 'done')), None)


def test_no_simulated_service_answers_for_a_real_one(place: Any) -> None:
    here, there, third = place('a'), place('b'), place('c')
    there.service('/reset')
    turns(here, there, third)
    assert [len(each.graph.services['/reset']) for each in (here, there, third)] == [1, 1, 1]
    assert [end.kind for link in (here.link, third.link) for end in link.ends.values()] == []


def test_only_what_was_chosen_crosses(place: Any) -> None:
    here, there = place('a', crossing=Crossing(['/turtle1', 'tf'])), place('b')
    for topic in ('/turtle1/pose', '/turtle10/pose', '/tf', '/rosout'):
        here.publisher(topic)
        there.publisher(topic)
    turns(here, there)
    assert [end.name for end in here.link.ends.values()] == ['/turtle1/pose', '/tf']
    assert [len(here.graph.publishers[topic]) for topic in ('/turtle1/pose', '/turtle10/pose', '/tf', '/rosout')] == [2, 1, 2, 1]


def test_what_cannot_talk_because_of_its_qos_is_told_here_as_among_simulated_nodes(place: Any, air: Air) -> None:
    here = place('a')
    real, node = raw(air)
    policies: list[str] = []
    here.subscription('/chatter').on_incompatible = policies.append
    real.add(node, PUBLISHER, '/chatter', UNDERLAY, QoS(reliability=BEST_EFFORT))
    turns(here)
    assert policies == ['RELIABILITY']


def test_another_definition_of_a_type_is_told(place: Any, air: Air) -> None:
    here = place('a')
    real, node = raw(air)
    handle = real.add(node, PUBLISHER, '/chatter', UNDERLAY, QoS())
    real.ends[handle] = real.ends[handle]._replace(hash='RIHS01_' + '0' * 64)
    turns(here)
    here.subscription('/chatter')
    turns(here)
    assert here.said == ['/chatter: std_msgs/msg/String has another definition on the network than here, so messages are misread']


def test_a_queue_that_is_full_is_read_before_its_oldest_message_is_dropped(place: Any) -> None:
    here, there = place('a'), place('b')
    publisher = here.publisher('/chatter', qos=QoS(depth=100))
    got: list[Any] = []

    def read() -> None:
        while (taken := queue.take()) is not None:
            got.append(taken[0])

    def ready() -> None:
        there.sim.schedule(there.sim.now_ns, read)

    queue = there.graph.create_subscription(there.node, '/chatter', cls_of(STRING), QoS(depth=3), ready)
    turns(here, there)
    for number in range(50):
        publisher.publish((str(number),))
    turns(here, there)
    assert got == [(str(number),) for number in range(50)]


def test_at_the_end_the_graph_is_as_it_was(place: Any) -> None:
    here, there = place('a'), place('b')
    publisher = here.publisher('/chatter')
    before = publisher.record
    there.subscription('/chatter')
    there.service('/reset')
    turns(here, there)
    assert publisher.record != before
    here.bridge.close()
    assert here.nodes() == ['/a'] and here.graph.services == {} and here.graph.subscriptions == {}
    assert publisher.record == before
    turns(there)
    assert there.nodes() == ['/b'] and there.graph.publishers == {}
    publisher.publish(('alone',))
    assert here.link.published == []


def test_real_ends_that_cannot_talk_with_each_other_are_not_this_machines_business(place: Any, air: Air) -> None:
    here = place('a')
    real, node = raw(air)
    for topic, reliability in (('/fine', 'reliable'), ('/odd', BEST_EFFORT)):
        real.add(node, PUBLISHER, topic, UNDERLAY, QoS(reliability=reliability))
        real.add(node, 'subscription', topic, UNDERLAY, QoS())
        real.add(node, PUBLISHER, topic, UNDERLAY, QoS(reliability=reliability))
    turns(here)
    for topic in ('/fine', '/odd'):
        assert [end.subscription_count for end in here.graph.publishers[topic]] == [0, 0]
    assert here.session.recorder.notes == []


@pytest.mark.parametrize(
    ('source_s', 'qos', 'told'),
    [
        (110, QoS(), "the clock of /real is 10 s ahead of this computer's"),
        (90, QoS(), 'a message of /real on /chatter is 10 s old: its clock or the network is slow'),
        (90, QoS(durability=TRANSIENT_LOCAL), None),
        (102, QoS(), None),
        (0, QoS(), None),
    ],
)
def test_the_clock_of_another_computer_is_told_when_it_is_far_off(
    place: Any, air: Air, source_s: int, qos: QoS, told: str | None
) -> None:
    """A message that was kept for late joiners may be old, and a link that knows no time of sending says 0."""
    here = place('a', wall_ns=lambda: 100 * 10**9)
    real, node = raw(air)
    handle = real.add(node, PUBLISHER, '/chatter', UNDERLAY, qos)
    here.subscription('/chatter')
    turns(here)
    air.now = max(0, source_s * 10**9 - 1)
    for _ in range(2):
        real.publish(handle, text('here'))
        if not source_s:
            here.link.events[-1] = here.link.events[-1]._replace(source_ns=0)
        turns(here)
    assert [line.partition('\n')[0] for line in here.said] == ([] if told is None else [told])
    assert len(here.heard) == 2


def test_an_endpoint_that_no_node_has_claimed_is_named_in_words(place: Any) -> None:
    unknown = place().bridge.mirror.unknown()
    assert unknown.fully_qualified_name == '_NODE_NAMESPACE_UNKNOWN_/_NODE_NAME_UNKNOWN_'
    assert named(unknown) == 'a node with an unknown name'


def test_listeners_that_come_and_go_leave_no_name_behind(place: Any, air: Air) -> None:
    here = place('a')
    for visit in range(3):
        real, node = raw(air)
        real.add(node, 'subscription', f'/visit{visit}', UNDERLAY, QoS())
        turns(here)
        assert here.bridge.mirror.listeners == {f'/visit{visit}': 1}
        real.close()
        turns(here)
    assert here.bridge.mirror.listeners == {}
