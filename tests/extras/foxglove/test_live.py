"""A machine as a client sees it: topics, messages, publishing, services, parameters and the graph, on ordered logs."""

from __future__ import annotations

import struct
from collections.abc import Iterator
from typing import Any

import pytest

pytest.importorskip('tornado')

from edulaunch.engine.interfaces.registry import underlay_registry
from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.engine.processes.streams import streams_of_programs
from edulaunch.extras.foxglove import conversation
from edulaunch.extras.foxglove.conversation import MOST_ROWS, Conversation, TooMuch
from edulaunch.extras.foxglove.feed import Refused
from edulaunch.extras.foxglove.live import ANSWER_NS, LiveFeed
from edulaunch.ros.serialization.cdr import deserialize, serialize
from edulaunch.runtime.session import Session
from tests.extras.foxglove.feeds import Machine, Spoken

TWIST, POSE = 'geometry_msgs/msg/Twist', 'turtlesim/msg/Pose'


@pytest.fixture
def session() -> Iterator[Session]:
    with Session() as made, streams_of_programs():
        yield made


def start(session: Session, *words: str) -> None:
    session.host.start(ProcessSpec(argv=('ros2', 'run', *words), name=words[1]))


def turtlesim(session: Session) -> Spoken:
    """A client of a machine with one turtlesim that has run for a second."""
    start(session, 'turtlesim', 'turtlesim_node')
    session.run(1.0)
    spoken = Spoken(Conversation(LiveFeed(Machine(session), 1)))
    spoken.turn()
    return spoken


def pose_of(cdr: bytes) -> Any:
    return deserialize(cdr, underlay_registry().get(POSE))


def twist(x: float, turn: float) -> bytes:
    return b'\x00\x01\x00\x00' + struct.pack('<6d', x, 0, 0, 0, 0, turn)


def test_the_first_words_are_who_serves_and_what_there_is(session: Session) -> None:
    spoken = turtlesim(session)
    texts = [one for one in spoken.log if isinstance(one, dict)]
    assert [one['op'] for one in texts] == ['serverInfo', 'advertise', 'advertiseServices']
    assert texts[0]['supportedEncodings'] == ['cdr', 'json'] and 'clientPublish' in texts[0]['capabilities']
    pose = spoken.entry('advertise', 'channels', '/turtle1/pose')
    assert (pose['encoding'], pose['schemaName'], pose['schemaEncoding']) == ('cdr', POSE, 'ros2msg')
    assert pose['schema'].splitlines()[0] == 'float32 x'
    spawn = spoken.entry('advertiseServices', 'services', '/spawn')
    assert spawn['request']['schemaName'] == 'turtlesim/srv/Spawn_Request'
    assert spawn['response']['schema'] == 'string name'


def test_a_subscriber_gets_each_message_once_with_its_time(session: Session) -> None:
    spoken = turtlesim(session)
    spoken.subscribe('/turtle1/pose')
    for seconds in (0.5, 0.25, 0.0):
        session.run(seconds)
        spoken.turn()
    published = session.recorder.columns['/turtle1/pose', POSE][::3]
    assert [time_ns for time_ns, _ in spoken.data()] == [ns for ns in published if ns > session.sim.start_ns + 10**9]
    assert pose_of(spoken.data()[0][1]).x == pytest.approx(5.544445)
    spoken.op('unsubscribe', subscriptionIds=[1])
    count = len(spoken.data())
    session.run(0.5)
    spoken.turn()
    assert len(spoken.data()) == count


def test_a_twist_of_the_client_moves_the_turtle_and_is_recorded(session: Session) -> None:
    spoken = turtlesim(session)
    spoken.subscribe('/turtle1/pose')
    spoken.op('advertise', channels=[{'id': 3, 'topic': '/turtle1/cmd_vel', 'encoding': 'cdr', 'schemaName': TWIST}])
    spoken.conversation.take(b'\x01\x03\x00\x00\x00' + twist(1.0, 0.0))
    session.run(0.5)
    spoken.turn()
    assert pose_of(spoken.data()[-1][1]).x == pytest.approx(6.04, abs=0.02)
    assert len(session.recorder.columns['/turtle1/cmd_vel', TWIST]) // 3 == 1
    assert [node.name for node in session.graph.nodes] == ['turtlesim', '_foxglove_1']
    spoken.op('unadvertise', channelIds=[3])
    assert '/turtle1/cmd_vel' not in session.graph.publishers
    spoken.conversation.close()
    assert [node.name for node in session.graph.nodes] == ['turtlesim']
    assert spoken.statuses() == []


def test_a_client_can_publish_in_json(session: Session) -> None:
    spoken = turtlesim(session)
    spoken.subscribe('/turtle1/pose')
    spoken.op('advertise', channels=[{'id': 3, 'topic': '/turtle1/cmd_vel', 'encoding': 'json', 'schemaName': TWIST}])
    spoken.conversation.take(b'\x01\x03\x00\x00\x00{"linear": {"x": 1}}')
    session.run(0.5)
    spoken.turn()
    assert pose_of(spoken.data()[-1][1]).x == pytest.approx(6.04, abs=0.02)
    assert spoken.statuses() == []


@pytest.mark.parametrize(
    ('text', 'said'),
    [
        ('{"linear": ', '/turtle1/cmd_vel: Expecting value'),
        ('[1]', "/turtle1/cmd_vel: b'[1]' is not an object with the fields of a geometry_msgs/msg/Twist"),
        ('{"linaer": {}}', "has no attribute 'linaer'"),
        ('{"linear": {"x": "fast"}}', "'x' is float64"),
        ('{"linear": 3}', 'is expected to be a dictionary'),
        ('[' * 100_000, '/turtle1/cmd_vel: '),
    ],
)
def test_json_that_does_not_fit_is_refused_with_a_sentence(session: Session, text: str, said: str) -> None:
    spoken = turtlesim(session)
    spoken.op('advertise', channels=[{'id': 3, 'topic': '/turtle1/cmd_vel', 'encoding': 'json', 'schemaName': TWIST}])
    spoken.conversation.take(b'\x01\x03\x00\x00\x00' + text.encode())
    session.run(0.1)
    spoken.turn()
    (status,) = spoken.statuses()
    assert said in status
    assert ('/turtle1/cmd_vel', TWIST) not in session.recorder.columns or not session.recorder.columns['/turtle1/cmd_vel', TWIST]


def test_what_a_client_may_not_publish_is_refused_with_a_sentence(session: Session) -> None:
    spoken = turtlesim(session)

    def advertise(topic: str, kind: str, encoding: str = 'cdr') -> None:
        spoken.op('advertise', channels=[{'id': 3, 'topic': topic, 'encoding': encoding, 'schemaName': kind}])

    advertise('/turtle1/cmd_vel', TWIST, 'protobuf')
    advertise('cmd vel', TWIST)
    advertise('/turtle1/cmd_vel', 'geometry_msgs/msg/Twits')
    advertise('/turtle1/cmd_vel', 'turtlesim/srv/Spawn')
    spoken.conversation.take(b'\x01\x03\x00\x00\x00' + twist(1.0, 0.0))
    advertise('/turtle1/cmd_vel', TWIST)
    spoken.conversation.take(b'\x01\x03\x00\x00\x00' + twist(1.0, 0.0)[:20])
    spoken.conversation.take('no JSON')
    spoken.turn()
    beginnings = (
        "/turtle1/cmd_vel: edulaunch takes messages in cdr or json, not in 'protobuf'",
        "'cmd vel' is not a topic name",
        "unknown interface 'geometry_msgs/msg/Twits'",
        'turtlesim/srv/Spawn is not a message type',
        'this client has no channel 3: advertise it first',
        '/turtle1/cmd_vel: these 20 bytes are not a geometry_msgs/msg/Twist',
        'this message is not JSON',
    )
    for status, beginning in zip(spoken.statuses(), beginnings, strict=True):
        assert status.startswith(beginning)


def test_a_latched_topic_comes_at_once_to_who_subscribes_late(session: Session) -> None:
    start(session, 'tf2_ros', 'static_transform_publisher', '--frame-id', 'a', '--child-frame-id', 'b')
    session.run(1.0)
    spoken = Spoken(Conversation(LiveFeed(Machine(session), 1)))
    spoken.turn()
    spoken.subscribe('/tf_static')
    spoken.turn()
    [(_, cdr)] = spoken.data()
    assert deserialize(cdr, underlay_registry().get('tf2_msgs/msg/TFMessage')).transforms[0].child_frame_id == 'b'


def test_a_service_answers_and_what_cannot_be_asked_is_said(session: Session) -> None:
    spoken = turtlesim(session)
    number = spoken.entry('advertiseServices', 'services', '/spawn')['id']
    request = underlay_registry().get('turtlesim/srv/Spawn').Request(x=1.0, y=2.0, name='ann')
    header = struct.pack('<BIII', 2, number, 77, 3) + b'cdr'
    spoken.conversation.take(header + serialize(request))
    spoken.conversation.take(header + b'\x00\x01\x00\x00\x01')
    spoken.conversation.take(struct.pack('<BIII', 2, 4000, 78, 3) + b'cdr')
    spoken.conversation.take(struct.pack('<BIII', 2, number, 79, 4) + b'json{}')
    session.run(0.2)
    heard = spoken.turn()
    assert struct.pack('<BIII', 3, number, 77, 3) + b'cdr\x00\x01\x00\x00\x04\x00\x00\x00ann\x00' in heard
    failures = [(one['callId'], one['message'].partition(' are not ')[0]) for one in spoken.texts('serviceCallFailure')]
    assert failures == [
        (77, '/spawn: these 5 bytes'),
        (78, 'this server has no service 4000'),
        (79, "/spawn: edulaunch takes requests in cdr, not in 'json'"),
    ]
    assert '/ann/pose' in {row['topic'] for text in spoken.texts('advertise') for row in text['channels']}


def test_a_service_that_does_not_answer_is_given_up(session: Session) -> None:
    spoken = turtlesim(session)
    number = spoken.entry('advertiseServices', 'services', '/clear')['id']
    session.graph.services['/clear'][0].on_ready = lambda: None
    spoken.conversation.take(struct.pack('<BIII', 2, number, 5, 3) + b'cdr\x00\x01\x00\x00\x00')
    session.run(ANSWER_NS / 1e9 + 0.1)
    spoken.turn()
    spoken.turn()
    assert [one['message'] for one in spoken.texts('serviceCallFailure')] == ['/clear did not answer within 30 s']


def test_parameters_are_read_set_and_watched(session: Session) -> None:
    spoken = turtlesim(session)
    red = '/turtlesim.background_r'
    spoken.op('getParameters', parameterNames=[red, '/nobody.x'], id='first')
    spoken.op('subscribeParameterUpdates', parameterNames=[red])
    spoken.turn()
    values = [{'name': red, 'value': 5}, {'name': '/turtlesim.holonomic', 'value': 'no'}, {'name': '/nobody.x', 'value': 1}]
    spoken.op('setParameters', parameters=values, id='second')
    session.run(0.5)
    spoken.turn()
    told = [(one.get('id'), one['parameters']) for one in spoken.texts('parameterValues')]
    assert told[:2] == [('first', [{'name': red, 'value': 69}]), (None, [{'name': red, 'value': 69}])]
    assert told[2:] == [
        ('second', [{'name': red, 'value': 5}, {'name': '/turtlesim.holonomic', 'value': False}]),
        (None, [{'name': red, 'value': 5}]),
    ]
    [status] = spoken.statuses()
    assert '/nobody.x: no node /nobody has parameters here' in status and '/turtlesim.holonomic: ' in status


@pytest.mark.parametrize(('name', 'value'), [('background_r', []), ('use_sim_time', [1, 'x']), ('background_g', 1 << 70)])
def test_a_value_that_a_parameter_cannot_have_is_refused(session: Session, name: str, value: Any) -> None:
    spoken = turtlesim(session)
    before = session.recorder.parameters[:]
    spoken.op('setParameters', parameters=[{'name': f'/turtlesim.{name}', 'value': value}], id='x')
    session.run(0.5)
    spoken.turn()
    [status] = spoken.statuses()
    assert status.startswith(f'/turtlesim.{name}: ') and session.recorder.parameters == before


def test_the_graph_is_told_once_and_then_what_differs(session: Session) -> None:
    spoken = turtlesim(session)
    spoken.op('subscribeConnectionGraph')
    spoken.turn()
    spoken.turn()
    spoken.op('advertise', channels=[{'id': 3, 'topic': '/x', 'encoding': 'cdr', 'schemaName': TWIST}])
    spoken.turn()
    spoken.op('unadvertise', channelIds=[3])
    spoken.turn()
    first, second, third = spoken.texts('connectionGraphUpdate')
    assert {'name': '/turtle1/cmd_vel', 'subscriberIds': ['/turtlesim']} in first['subscribedTopics']
    assert second['publishedTopics'] == [{'name': '/x', 'publisherIds': ['/_foxglove_1']}] and not second['subscribedTopics']
    assert (third['publishedTopics'], third['removedTopics']) == ([], ['/x'])


def test_topics_that_go_are_taken_back(session: Session) -> None:
    spoken = turtlesim(session)
    spoken.subscribe('/turtle1/pose')
    channel = spoken.entry('advertise', 'channels', '/turtle1/pose')['id']
    session.graph.remove_node(session.graph.nodes[0])
    spoken.turn()
    assert channel in spoken.texts('unadvertise')[0]['channelIds'] and spoken.texts('unadvertiseServices')
    session.run(0.1)
    spoken.turn()
    assert spoken.statuses() == []


def test_a_client_that_comes_seldom_gets_the_newest_and_hears_how_many_it_missed(session: Session) -> None:
    spoken = turtlesim(session)
    spoken.subscribe('/turtle1/pose')
    session.run(20.0)
    spoken.turn()
    published = session.recorder.columns['/turtle1/pose', POSE][::3]
    assert [time_ns for time_ns, _ in spoken.data()] == published[-MOST_ROWS:]
    spoken.turn()
    missed = len([ns for ns in published if ns > session.sim.start_ns + 10**9]) - MOST_ROWS
    assert spoken.statuses() == [f'{missed} messages of /turtle1/pose were left out: this client or the network is too slow']


def test_the_bytes_of_one_turn_are_limited(session: Session, monkeypatch: pytest.MonkeyPatch) -> None:
    spoken = turtlesim(session)
    spoken.subscribe('/turtle1/pose')
    session.run(1.0)
    monkeypatch.setattr(conversation, 'MOST_BYTES', 100)
    spoken.turn()
    assert len(spoken.data()) == 100 // 24


def test_a_client_that_asks_on_and_never_reads_is_let_go(session: Session, monkeypatch: pytest.MonkeyPatch) -> None:
    spoken = turtlesim(session)
    monkeypatch.setattr(conversation, 'MOST_WAITING', 10_000)
    with pytest.raises(TooMuch):
        for _ in range(1000):
            spoken.op('getParameters', parameterNames=[])


def test_another_session_on_the_machine_begins_anew(session: Session) -> None:
    machine = Machine(session)
    spoken = Spoken(Conversation(LiveFeed(machine, 1)))
    spoken.turn()
    with Session() as other:
        machine.session = other
        spoken.turn()
        assert len({one['sessionId'] for one in spoken.texts('serverInfo')}) == 2


@pytest.mark.parametrize(
    ('topic', 'why'), [('chatter', 'it has to begin with a slash'), ('/two words', "'/two words' is not a topic name")]
)
def test_a_client_may_publish_only_on_a_full_topic_name(session: Session, topic: str, why: str) -> None:
    with pytest.raises(Refused, match=why):
        LiveFeed(Machine(session), 1).advertise(topic, TWIST, 'cdr')
