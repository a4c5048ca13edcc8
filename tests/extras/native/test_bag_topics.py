"""Topics of a real network for `ros2 bag record`, on a node that stands for a real one."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import pytest
from rclpy.qos import QoSProfile

from edulaunch.engine.graph.qos import QoS
from edulaunch.extras.native import bag_topics
from edulaunch.extras.native.qos import to_rclpy

STRING = 'std_msgs/msg/String'


class FakeNode:
    """Answers as a node of the real rclpy does; `waiting` are the messages that wait in the middleware."""

    def __init__(self, publishers: dict[str, list[tuple[str, QoS]]]) -> None:
        self.publishers = publishers
        self.context = SimpleNamespace(waits=[])
        self.warnings: list[str] = []
        self.asked: list[tuple[Any, str, QoSProfile, bool, bool]] = []
        self.waiting: list[tuple[bytes, object]] = []
        self.callback: Callable[[bytes, Any], None] = lambda data, info: None

    def get_publishers_info_by_topic(self, topic: str) -> list[Any]:
        return [SimpleNamespace(topic_type=name, qos_profile=to_rclpy(qos)) for name, qos in self.publishers.get(topic, [])]

    def get_logger(self) -> Any:
        return SimpleNamespace(warning=self.warnings.append)

    def create_subscription(self, kind: Any, topic: str, callback: Any, qos: Any, *, raw: bool, event_callbacks: Any) -> Any:
        self.asked.append((kind, topic, qos, raw, event_callbacks.use_default_callbacks))
        self.callback = callback

        def take_message(of_kind: Any, is_raw: bool) -> tuple[bytes, object] | None:
            assert (of_kind, is_raw) == (kind, True)
            return self.waiting.pop(0) if self.waiting else None

        return SimpleNamespace(handle=SimpleNamespace(take_message=take_message))


class FakeExecutor:
    def __init__(self) -> None:
        self.nodes: list[Any] = []

    def add_node(self, node: Any) -> None:
        self.nodes.append(node)

    def spin_once(self) -> list[Any]:
        return self.nodes


@pytest.fixture
def node(monkeypatch: pytest.MonkeyPatch) -> FakeNode:
    monkeypatch.setattr(bag_topics, 'SingleThreadedExecutor', FakeExecutor)
    reliable, lossy = QoS(7), QoS(3, 'best_effort')
    return FakeNode({'/a': [(STRING, reliable), (STRING, lossy)], '/odd': [('no_msgs/msg/Such', reliable)]})


def test_waiting_in_the_context_spins_the_node(node: FakeNode) -> None:
    bag_topics.BagTopics(node, 'process')
    assert [spin() for spin in node.context.waits] == [[node]]


def test_a_topic_can_be_recorded_when_it_has_a_publisher_of_a_known_type(node: FakeNode) -> None:
    topics = bag_topics.BagTopics(node, 'process')
    assert topics.entry.process == 'process'
    assert [name in topics.publishers for name in ('/a', '/nobody', '/odd', '/odd')] == [True, False, False, False]
    assert node.warnings == ["Topic '/odd' has unknown type 'no_msgs/msg/Such'. Only topics with known type are supported."], (
        'it warns once'
    )


def test_each_publisher_is_listed_with_its_type_and_policies(node: FakeNode) -> None:
    topics = bag_topics.BagTopics(node, 'process')
    rows = [(each.topic_name, each.cls.TYPE, each.qos.depth, each.qos.reliability) for each in topics.publishers['/a']]
    assert rows == [('/a', STRING, 7, 'reliable'), ('/a', STRING, 3, 'best_effort')]
    assert all(each.graph is topics for each in topics.publishers['/a'])


def test_a_subscription_takes_all_that_waits_before_it_calls(node: FakeNode) -> None:
    topics = bag_topics.BagTopics(node, 'process')
    sizes: list[int] = []
    made = topics.create_subscription(None, '/a', SimpleNamespace(TYPE=STRING), QoS(5), lambda: sizes.append(len(made.queue)))
    ((kind, topic, qos, raw, has_callbacks),) = node.asked
    assert (kind.TYPE, topic, qos.depth, raw, has_callbacks) == (STRING, '/a', 5, True, False)
    node.waiting = [(b'two', None), (b'three', None)]
    node.callback(b'one', None)
    assert list(made.queue) == [(b'one',), (b'two',), (b'three',)] and sizes == [3]


def test_one_turn_takes_a_hundred_messages_at_most(node: FakeNode) -> None:
    topics = bag_topics.BagTopics(node, 'process')
    made = topics.create_subscription(None, '/a', SimpleNamespace(TYPE=STRING), QoS(5), lambda: None)
    node.waiting = [(b'%d' % number, None) for number in range(1, 250)]
    node.callback(b'0', None)
    assert [int(row[0]) for row in made.queue] == list(range(bag_topics.AT_ONCE))


def test_the_first_publisher_decides_about_the_type(node: FakeNode) -> None:
    node.publishers['/two'] = [('no_msgs/msg/Such', QoS(1)), (STRING, QoS(1))]
    node.publishers['/three'] = [(STRING, QoS(1)), ('no_msgs/msg/Such', QoS(1))]
    topics = bag_topics.BagTopics(node, 'process')
    assert [name in topics.publishers for name in ('/two', '/three')] == [False, True]
    assert [each.cls.TYPE for each in topics.publishers['/three']] == [STRING, STRING]
