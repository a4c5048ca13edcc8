"""Handles."""

from __future__ import annotations

from typing import Any

import pytest
from rclpy._rclpy_pybind11 import InvalidHandle
from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import Empty

from .conftest import Ros, World


def _entities(node: Node) -> dict[str, Any]:
    return {
        'publisher': node.create_publisher(String, 't', 1),
        'subscription': node.create_subscription(String, 't', print, 1),
        'client': node.create_client(Empty, 'e'),
        'service': node.create_service(Empty, 'e', print),
        'timer': node.create_timer(1.0, print),
        'guard_condition': node.create_guard_condition(print),
    }


def test_handles_can_be_used_until_their_entity_is_destroyed(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        entities = _entities(node)
        for entity in (*entities.values(), node, node.get_clock(), node.context):
            with entity.handle as inside:
                assert inside is None
        node.destroy_node()
        for name, entity in {**entities, 'node': node}.items():
            try:
                with entity.handle:
                    world.say(name)
            except InvalidHandle as error:
                assert str(error) == 'cannot use Destroyable because destruction was requested'
        world.say('done')

    assert ros(body) == ['done']


def test_nodes_and_entities_are_not_for_with_only_their_handles_are(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        world.say([name for name, one in {**_entities(node), 'node': node}.items() if hasattr(one, '__enter__')])

    assert ros(body) == [[]]


def test_entities_know_their_nodes_logger_until_they_are_destroyed(ros: Ros, world: World) -> None:
    def body() -> None:
        entities = _entities(Node('n', namespace='a/b'))
        for kind in ('publisher', 'subscription', 'client', 'service'):
            world.say(entities[kind].logger_name)
            entities[kind].destroy()
            with pytest.raises(InvalidHandle):
                _ = entities[kind].logger_name

    assert ros(body) == ['a.b.n'] * 4
