"""Handles, and entities that end with a block."""
from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from rclpy._rclpy_pybind11 import InvalidHandle
from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import Empty

from .conftest import World

Ros = Callable[..., list[Any]]


def _entities(node: Node) -> dict[str, Any]:
    return {
        'publisher': node.create_publisher(String, 't', 1), 'subscription': node.create_subscription(String, 't', print, 1),
        'client': node.create_client(Empty, 'e'), 'service': node.create_service(Empty, 'e', print),
        'timer': node.create_timer(1.0, print), 'guard_condition': node.create_guard_condition(print)}


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


def test_entities_destroy_themselves_at_the_end_of_their_block(ros: Ros, world: World) -> None:
    def body() -> None:
        with Node('n') as node:
            for name, entity in _entities(node).items():
                with entity as inside:
                    assert inside is entity
                with pytest.raises(InvalidHandle), entity.handle:
                    world.say(name)
        with pytest.raises(InvalidHandle):
            node.get_name()
        world.say('done')

    assert ros(body) == ['done']
