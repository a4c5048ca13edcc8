"""rclpy.action.graph: what nodes know of actions."""

from __future__ import annotations

import pytest
import rclpy
from example_interfaces.action import Fibonacci
from rclpy._rclpy_pybind11 import RCLError
from rclpy.action import (
    ActionClient,
    ActionServer,
    get_action_client_names_and_types_by_node,
    get_action_names_and_types,
    get_action_server_names_and_types_by_node,
)
from rclpy.node import Node

from .conftest import Ros, World
from .fibonacci import compute


def test_the_graph_of_actions_has_errors_of_its_own(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        with pytest.raises(RCLError, match='^Failed to get action server names and type: error not set$'):
            get_action_server_names_and_types_by_node(node, 'nobody', '/')
        rclpy.shutdown()
        with pytest.raises(RCLError, match="^Failed to get action names and type: rcl node's context is invalid$"):
            get_action_names_and_types(node)
        world.say('asked')

    assert ros(body) == ['asked']


def test_actions_are_seen_in_the_graph(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        ActionServer(node, Fibonacci, 'fibonacci', compute)
        other = Node('other')
        ActionClient(other, Fibonacci, 'fibonacci')
        world.say(
            (
                get_action_names_and_types(node),
                get_action_server_names_and_types_by_node(other, 'n', '/'),
                get_action_client_names_and_types_by_node(node, 'other', '/'),
                get_action_client_names_and_types_by_node(node, 'n', '/'),
            )
        )

    found = [('/fibonacci', ['example_interfaces/action/Fibonacci'])]
    assert ros(body) == [(found, found, found, [])]
