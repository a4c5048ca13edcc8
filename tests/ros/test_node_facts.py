"""Which rclpy answers about a node's own state can be chosen."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest
from rclpy.node import Node

import edulaunch
from edulaunch.ros import node_facts
from edulaunch.ros.node_facts import choose, core_of


@pytest.fixture
def as_before() -> Iterator[None]:
    yield
    choose(node_facts._in_our_rclpy)


def test_our_rclpy_answers_with_the_state_of_the_node() -> None:
    edulaunch.source()
    import rclpy

    rclpy.init(args=[])
    node = Node('talker', namespace='/a')
    core = core_of(node)
    node.destroy_node()
    rclpy.shutdown()
    assert (core.full_name, core.destroyed) == ('/a/talker', True)


def test_another_that_was_chosen_answers_in_its_place(as_before: None) -> None:
    asked: list[Any] = []

    def other(node: Any) -> str:
        asked.append(node)
        return 'the real one'

    choose(other)
    assert core_of('a node') == 'the real one' and asked == ['a node']
