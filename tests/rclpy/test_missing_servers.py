"""Requests without a server: ROS 2 says nothing, the recording does."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionClient
from rclpy.node import Node
from std_srvs.srv import Empty, Trigger

from .conftest import World


def noted(world: World, body: Callable[[Node], Any]) -> list[tuple[str, str]]:
    """The notes that a program leaves, without the place in this file."""
    import re

    def program() -> None:
        rclpy.init()
        elsewhere = rclpy.Context()
        rclpy.init(context=elsewhere)
        Node('server', context=elsewhere).create_service(Empty, '/spawn', lambda request, response: response)
        body(Node('node'))

    world.start(program)
    world.run(60)
    return [(kind, re.sub(r' \(test_missing_servers.py:\d+\)', '', text)) for kind, text in world.tracer.notes]


def test_a_request_to_nobody_is_noted_once(world: World) -> None:
    def body(node: Node) -> None:
        client = node.create_client(Empty, '/spwan')
        client.call_async(Empty.Request())
        client.call_async(Empty.Request())

    assert noted(world, body) == [
        (
            'lost request',
            (
                "node '/node' asks service '/spwan', but nobody offers it (did you mean '/spawn'?), so the request is lost and no answer "
                'will ever come. Wait for the server first: client.wait_for_service()'
            ),
        )
    ]


def test_a_server_of_another_type_is_named(world: World) -> None:
    ((_, text),) = noted(world, lambda node: node.create_client(Trigger, '/spawn').call_async(Trigger.Request()))
    assert 'but its server has the type std_srvs/srv/Empty, the client std_srvs/srv/Trigger, so the request is lost' in text


def test_a_goal_to_nobody_is_noted(world: World) -> None:
    ((kind, text),) = noted(world, lambda node: ActionClient(node, Fibonacci, 'count').send_goal_async(Fibonacci.Goal()))
    assert (kind, text.split(', so')[0]) == ('lost request', "node '/node' asks action '/count', but nobody offers it")


def test_a_wait_of_ten_seconds_is_noted(world: World) -> None:
    def body(node: Node) -> None:
        client = node.create_client(Empty, 'spawm')
        while not client.wait_for_service(1.0):
            if node.get_clock().now().nanoseconds > world.sim.start_ns + 40 * 10**9:
                return

    assert noted(world, body) == [
        ('no server', ("node '/node' has waited 10 s for service '/spawm', but nobody offers it (did you mean '/spawn'?)"))
    ]


def test_a_server_that_comes_in_time_is_no_news(world: World) -> None:
    def body(node: Node) -> None:
        world.start(late, name='late')
        client = node.create_client(Empty, 'late')
        client.wait_for_service()
        client.call_async(Empty.Request())

    def late() -> None:
        rclpy.init()
        from edulaunch.sim.sync import sleep

        sleep(5)
        rclpy.spin(node_with_service())

    def node_with_service() -> Node:
        node = Node('late')
        node.create_service(Empty, 'late', lambda request, response: response)
        return node

    assert noted(world, body) == []
