"""Who sent which message when, and numbers of messages over time."""

from __future__ import annotations

import pytest

from edulaunch.engine.graph.qos import BEST_EFFORT, QoS
from edulaunch.engine.recording import Recording
from edulaunch.engine.recording.messages import seconds
from edulaunch.errors import RecordingError

from .conftest import Stage

POSE, TF = 'turtlesim/msg/Pose', 'tf2_msgs/msg/TFMessage'


@pytest.fixture
def two_senders(stage: Stage) -> Recording:
    """Two nodes publish poses on /t in turn, and a third one hears them; a second topic has another type of the same name."""
    from turtlesim.msg import Color, Pose

    process = stage.process('p', 50.0)
    nodes = [stage.graph.add_node(process, name, '/ns') for name in ('a', 'b', 'c')]
    ends = [
        stage.graph.create_publisher(node, '/t', Pose, qos)
        for node, qos in zip(nodes, (QoS(), QoS(3, BEST_EFFORT)), strict=False)
    ]
    colors = stage.graph.create_publisher(nodes[1], '/t', Color, QoS(7))
    stage.graph.create_subscription(nodes[2], '/t', Pose, QoS(), lambda: None)
    for step in range(4):
        stage.at(step * 0.25, lambda step=step: ends[step % 2].publish(Pose.to_wire(Pose(x=float(step), y=-1.0))))
    stage.at(0.1, lambda: colors.publish(Color.to_wire(Color(r=9))))
    return stage.finish(2.0)


def test_a_topic_names_its_nodes_once_and_counts_all_its_messages(two_senders: Recording) -> None:
    topic = two_senders.topics['/t']
    assert (topic.name, topic.type, topic.publishers, topic.subscriptions) == ('/t', POSE, ['/ns/a', '/ns/b'], ['/ns/c'])
    assert topic.count == 5


def test_messages_of_several_senders_are_in_the_order_of_their_times(two_senders: Recording) -> None:
    heard = [(time, getattr(message, 'x', None), getattr(message, 'r', None)) for time, message in two_senders.messages('/t')]
    assert heard == [(0.0, 0.0, None), (0.1, None, 9), (0.25, 1.0, None), (0.5, 2.0, None), (0.75, 3.0, None)]
    wires = two_senders.wires('/t', POSE)
    assert [(time, wire[:2]) for time, wire in wires] == [
        (0, (0.0, -1.0)),
        (250_000_000, (1.0, -1.0)),
        (500_000_000, (2.0, -1.0)),
        (750_000_000, (3.0, -1.0)),
    ]
    assert two_senders.wires('/t', TF) == two_senders.wires('/no', POSE) == []


def test_each_message_is_known_with_its_sender(two_senders: Recording) -> None:
    sent = two_senders.published('/t', POSE)
    assert [(time, node, wire[0]) for time, node, wire in sent] == [
        (0, '/ns/a', 0.0),
        (250_000_000, '/ns/b', 1.0),
        (500_000_000, '/ns/a', 2.0),
        (750_000_000, '/ns/b', 3.0),
    ]
    assert two_senders.published('/t', 'turtlesim/msg/Color') == [(100_000_000, '/ns/b', (9, 0, 0))]


def test_what_each_publisher_offered_is_in_the_order_of_their_creation(two_senders: Recording) -> None:
    assert [(qos.depth, qos.reliability) for qos in two_senders.offered('/t')] == [
        (QoS().depth, QoS().reliability),
        (3, BEST_EFFORT),
        (7, QoS().reliability),
    ]
    assert two_senders.offered('/no') == []


def test_numbers_over_time_are_those_of_the_messages(recording: Recording) -> None:
    assert recording.series('/turtle1/pose', 'y', 'x')[:2] == [(0.0, 2.0, 1.0), (0.5, 2.0, 2.0)]
    moved = recording.series('/tf', 'transforms[0].transform.translation.x', 'transforms[0].header.stamp.sec')
    assert moved[:2] == [(0.0, 1.0, 1_700_000_000), (0.5, 2.0, 1_700_000_000)] and len(moved) == 5
    with pytest.raises(ValueError, match='at least one field'):
        recording.series('/turtle1/pose')
    assert list(recording.series('/no', 'x')) == []


def test_a_type_that_is_not_known_here_is_an_error_of_the_recording(recording: Recording) -> None:
    assert recording.message_class(POSE) is recording.registry.get(POSE)
    with pytest.raises(RecordingError, match="unknown interface 'my/msg/Leg'"):
        recording.message_class('my/msg/Leg')


def test_calls_have_their_request_and_the_time_of_their_reply(recording: Recording) -> None:
    (call,) = recording.service_calls
    assert (call.time_s, call.service, call.type, call.client, call.served) == (
        0.25,
        '/spawn',
        'turtlesim/srv/Spawn',
        '/ns/watcher',
        True,
    )
    assert (call.request.x, call.request.name, call.replied_s, call.response.name) == (4.0, 'turtle2', 0.25, 'turtle2')


def test_nanoseconds_are_seconds_and_nothing_stays_nothing() -> None:
    assert (seconds(1_500_000_000), seconds(0), seconds(None)) == (1.5, 0.0, None)
