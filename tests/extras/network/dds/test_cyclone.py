"""Machines and others on one domain of the loopback, by Cyclone DDS."""

from __future__ import annotations

import time
from typing import Any

import pytest

from edulaunch.engine.graph.qos import BEST_EFFORT, KEEP_ALL, TRANSIENT_LOCAL, QoS
from edulaunch.engine.interfaces.registry import Registry, underlay_registry
from edulaunch.extras.network.network_link import Interface, LinkDiagnostic, Message, Response, Settings
from edulaunch.ros.serialization.cdr import encode
from tests.extras.network.places import PUBLISHER, STRING, text, words_in

UNDERLAY = Interface(STRING, underlay_registry())
TWIST = 'geometry_msgs/msg/Twist'
SPIN = (1.0, 0.0, 0.0, 0.0, 0.0, -2.5)


def test_topics_cross_both_ways(wire: Any) -> None:
    here, there = wire.place('a'), wire.place('b')
    pose, command = here.publisher('/pose', TWIST), there.publisher('/command', TWIST)
    here.subscription('/command', TWIST)
    there.subscription('/pose', TWIST)
    wire.until(lambda: pose.subscription_count and command.subscription_count)
    wire.until(lambda: here.heard and there.heard, lambda: (pose.publish(SPIN), command.publish(SPIN)))
    assert here.heard[0] == there.heard[0] == SPIN
    assert here.nodes() == ['/a', '/b'] and sorted(there.nodes()) == ['/a', '/b']


def test_who_joins_late_gets_what_stays(wire: Any) -> None:
    here = wire.place('a')
    frames = here.publisher('/tf_static', qos=QoS(depth=1, durability=TRANSIENT_LOCAL))
    frames.publish(('old',))
    frames.publish(('base_link',))
    there = wire.place('b')
    there.subscription('/tf_static', qos=QoS(depth=1, durability=TRANSIENT_LOCAL))
    wire.until(lambda: there.heard)
    assert there.heard == [('base_link',)]


def test_the_policies_and_the_hash_of_a_real_endpoint_are_seen(wire: Any) -> None:
    here, real = wire.place('a'), wire.link()
    qos = QoS(reliability=BEST_EFFORT, durability=TRANSIENT_LOCAL, deadline_ns=10**8, lease_ns=10**9, lifespan_ns=2 * 10**9)
    real.add(real.add_node('/lab', 'lidar'), PUBLISHER, '/scan', UNDERLAY, qos)
    wire.until(lambda: '/scan' in here.graph.publishers)
    [mirrored] = here.graph.publishers['/scan']
    assert mirrored.node.fully_qualified_name == '/lab/lidar'
    assert mirrored.qos == qos
    [end] = here.link.graph().endpoints
    assert end.hash == UNDERLAY.hash and end.gid[:2] == b'\x01\x10'


def test_a_peer_that_leaves_is_gone_and_one_that_comes_back_is_heard(wire: Any) -> None:
    here = wire.place('a')
    here.subscription('/chatter')
    for words in ('first', 'second'):
        real = wire.link()
        mouth = real.add(real.add_node('/', 'talker'), PUBLISHER, '/chatter', UNDERLAY, QoS())
        wire.until(
            lambda words=words: (words,) in here.heard,
            lambda real=real, mouth=mouth, words=words: real.publish(mouth, text(words)),
        )
        wire.links.remove(real)
        real.close()
        wire.until(lambda: here.nodes() == ['/a'] and '/chatter' not in here.graph.publishers)


def test_who_told_of_his_nodes_just_before_he_left_is_gone(wire: Any) -> None:
    """What he said and his end are read together."""
    here, real = wire.link(), wire.link()
    real.add_node('/', 'talker')
    wire.until(lambda: [node.name for node in here.graph().nodes] == ['talker'], here.take)
    real.add_node('/', 'late')
    real.flush()
    wire.links.remove(real)
    real.close()
    wire.until(lambda: not here.graph().nodes, here.take)


def test_services_of_two_bridges_answer_each_other(wire: Any) -> None:
    here, there = wire.place('a'), wire.place('b')
    client, other = here.client('/reset'), wire.place('c').client('/reset')
    there.service('/reset')
    wire.until(lambda: client.server_is_ready() and other.server_is_ready())
    sent = []

    def ask() -> None:  # whoever asks while the two are still being matched is not heard, as in ROS 2
        if not client.queue and len(sent) < 200:
            sent.append(client.send(()))

    wire.until(lambda: client.queue, ask)
    assert client.take()[1] == (True, 'done') and not other.queue


def test_a_service_is_seen_only_by_those_who_can_use_it(wire: Any) -> None:
    here = wire.place('a')
    here.service('/reset')
    for _ in range(20):
        wire.until(lambda: True)
        here.turn()
    assert not any(end.is_on for end in here.link._ends.values())
    there = wire.place('b')
    wire.until(lambda: '/reset' in there.graph.services)


def test_a_students_own_message_crosses(wire: Any, tmp_path: Any) -> None:
    folder = tmp_path / 'robot_msgs' / 'msg'
    folder.mkdir(parents=True)
    (folder / 'Part.msg').write_text('string<=10 name\nuint8[4] raw\nfloat32[] weights\nint64[<=3] serialize\n')
    (folder / 'Robot.msg').write_text('Part[] parts\nPart[2] arms\nwstring title\nstd_msgs/Header header\n')
    (folder / 'Nothing.msg').write_text('')
    registry = Registry([tmp_path], underlay_registry())
    here, there = wire.link(), wire.link()
    part = ('arm', bytes(4), (0.5, 2.0), (1, 2))
    values = {'Robot': ((part, part), (part, part), 'Ω', 1, 2, 'map'), 'Nothing': ()}
    for name, value in values.items():
        interface = Interface(f'robot_msgs/msg/{name}', registry)
        mouth = here.add(here.add_node('/', 'a'), PUBLISHER, f'/{name}', interface, QoS())
        there.add(there.add_node('/', 'b'), 'subscription', f'/{name}', interface, QoS())
        cdr, came = encode(registry.get(interface.name), value), []

        def talk(mouth: int = mouth, cdr: bytes = cdr, came: list[Any] = came) -> None:
            here.publish(mouth, cdr)
            here.take()
            came += [event.cdr for event in there.take() if isinstance(event, Message)]

        wire.until(lambda came=came: came, talk)
        assert came[0].startswith(cdr) and len(came[0]) - len(cdr) < 4


def test_two_thousand_messages_a_second_arrive_all_in_order(wire: Any) -> None:
    here, real = wire.place('a'), wire.link()
    mouth = real.add(real.add_node('/', 'fast'), PUBLISHER, '/fast', UNDERLAY, QoS(depth=1000))
    ear = here.subscription('/fast', qos=QoS(depth=10))
    wire.until(lambda: ear.publisher_count)
    wire.until(lambda: here.heard, lambda: (real.take(), real.publish(mouth, text('first'))))
    began_s, sent = time.monotonic(), 0

    def talk() -> None:
        nonlocal sent
        due = min(4000, int((time.monotonic() - began_s) * 2000))
        for sent in range(sent, min(due, sent + 200)):  # noqa: B020
            real.publish(mouth, text(str(sent)))
        sent = min(due, sent + 1) if due > sent else sent
        real.take()

    wire.until(lambda: ('3999',) in here.heard[-1:], talk)
    assert [words for (words,) in here.heard if words != 'first'] == [str(number) for number in range(4000)]


def test_bytes_that_are_no_message_do_not_even_leave(wire: Any) -> None:
    here, real = wire.place('a'), wire.link()
    mouth = real.add(real.add_node('/', 'evil'), PUBLISHER, '/chatter', UNDERLAY, QoS())
    here.subscription('/chatter')
    wire.until(lambda: here.heard, lambda: real.publish(mouth, text('begin')))
    for bad in (b'\0\1\0\0', b'\0\1\0\0\xff\xff\xff\x7f', b'\0\0\0\0abcd', b'\0\1\0\0\4\0\0\0\xff\xff\xff\xff'):
        real.publish(mouth, bad)
    assert {event.key for event in real.take() if isinstance(event, LinkDiagnostic)} == {'not sent /chatter -3'}
    wire.until(lambda: ('end',) in here.heard, lambda: real.publish(mouth, text('end')))
    assert set(here.heard) == {('begin',), ('end',)}


def test_too_many_endpoints_are_told_and_the_machine_goes_on(wire: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr('edulaunch.extras.network.dds.discovery.MOST_ENDPOINTS', 20)
    here, real = wire.place('a'), wire.link()
    node = real.add_node('/', 'many')
    for number in range(60):
        real.add(node, PUBLISHER, f'/topic{number}', UNDERLAY, QoS())
    wire.until(lambda: here.said)
    assert here.said == ['the network has more than 20 endpoints: later ones are ignored']
    assert len(here.link.graph().endpoints) == 20


def test_messages_of_all_sizes_and_histories_cross_between_links(wire: Any) -> None:
    here, there = wire.link(), wire.link()
    qos = QoS(history=KEEP_ALL)
    mouth = here.add(here.add_node('/', 'a'), PUBLISHER, '/big', UNDERLAY, qos)
    there.add(there.add_node('/', 'b'), 'subscription', '/big', UNDERLAY, qos)
    came: list[str] = []

    def take() -> None:
        here.take()
        came.extend(words_in(event.cdr) for event in there.take() if isinstance(event, Message))

    wire.until(lambda: came, lambda: (here.publish(mouth, text('begin')), take()))
    sizes = [0, 1, 2, 3, 4, 5, 100, 70_000, 1_000_000]
    for size in sizes:
        here.publish(mouth, text('x' * size))
    wire.until(lambda: len([words for words in came if words != 'begin']) == len(sizes), take)
    assert [len(words) for words in came if words != 'begin'] == sizes


def test_the_network_of_a_machine_is_the_loopback_unless_asked_for_more(domain: int) -> None:
    from edulaunch.extras.network.dds.domain import configuration

    alone = configuration(Settings())
    assert '<NetworkInterface address="127.0.0.1"' in alone and alone.count('Peer Address') == 1
    wide = configuration(Settings(0, 'SUBNET', ('robot.local',)))
    assert 'autodetermine="true"' in wide and 'Address="robot.local"' in wide and '127.0.0.1' not in wide
    assert '<Peers></Peers>' in configuration(Settings(0, 'OFF'))


def test_nobody_hears_himself_and_sees_himself_among_the_others(wire: Any) -> None:
    here, there = wire.place('a'), wire.place('b')
    mouth = here.publisher('/chatter')
    here.subscription('/chatter')
    there.publisher('/chatter')
    there.subscription('/chatter')
    wire.until(lambda: mouth.subscription_count == 2 and len(here.graph.publishers['/chatter']) == 2)
    wire.until(lambda: there.heard, lambda: mouth.publish(('hello',)))
    count, sent = len(here.heard), there.publisher('/end')
    here.subscription('/end')
    wire.until(lambda: ('end',) in here.heard, lambda: sent.publish(('end',)))
    assert here.heard[:count] == [('hello',)] * count and ('hello',) not in here.heard[count:]
    assert {end.node.name for end in here.link.graph().endpoints} == {'b'}


def test_a_reply_for_somebody_else_is_not_taken(domain: int) -> None:
    from edulaunch.extras.network.dds.link import End, _event

    end = End(1, 'client', '/reset', UNDERLAY, QoS())
    reply = b'\0\1\0\0%s' + (7).to_bytes(8, 'little') + b'answer'
    assert _event(3, end, b'\x01\x10', 0, reply % b'somebody') is None
    assert _event(3, end, b'\x01\x10', 0, reply % end.id) == Response(3, 7, b'\0\1\0\0answer')
    for gid, data in ((b'\x01\x0f', reply % end.id), (b'\x01\x10', b'\0\1\0\0short')):
        assert isinstance(_event(3, end, gid, 0, data), LinkDiagnostic)


def test_topics_that_come_and_go_leave_no_object_of_cyclone_behind(domain: int) -> None:
    from cyclonedds.core import Entity

    from edulaunch.extras.network.dds.link import CycloneLink

    link = CycloneLink()
    link.open(Settings(domain))
    node, counts = link.add_node('/', 'node'), []
    stays = link.add(node, PUBLISHER, '/visit0', UNDERLAY, QoS())
    for visit in range(5):
        guests = [link.add(node, kind, f'/visit{visit}', UNDERLAY, QoS()) for kind in (PUBLISHER, 'subscription')]
        for guest in guests:
            link.remove(guest)
        counts.append((len(Entity._entities), len(link._topics)))
    link.publish(stays, text('still here'))
    assert counts == [counts[0]] * 5 and counts[0][1] == 1
    assert not any(isinstance(event, LinkDiagnostic) for event in link.take())
    link.close()


def test_the_user_data_of_a_sample_of_discovery_is_freed_once(monkeypatch: pytest.MonkeyPatch) -> None:
    import ctypes

    from cyclonedds.qos import Policy, Qos, _CQos

    from edulaunch.extras.network.dds.qos import _FreeingQos, qos_from

    free, freed = _FreeingQos.free, []

    def counted(value: Any) -> None:
        freed.append(value.value)
        free(value)

    monkeypatch.setattr(_FreeingQos, 'free', counted)
    with_data, without = (_CQos.qos_to_cqos(qos) for qos in (Qos(Policy.Userdata(b'typehash=x;')), Qos(Policy.Deadline(5))))
    for pointer in (with_data, without, with_data):
        found = qos_from(ctypes.cast(pointer, ctypes.c_void_p).value)
        assert (Policy.Userdata in found) is (pointer is with_data)
        _CQos.cqos_destroy(pointer) if pointer is without else None
    assert [value is not None for value in freed] == [True, False, True]
    _CQos.cqos_destroy(with_data)
