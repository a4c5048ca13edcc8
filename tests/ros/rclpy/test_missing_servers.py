"""Requests without a server: ROS 2 says nothing, the recording has the facts."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionClient
from rclpy.node import Node
from std_srvs.srv import Empty

from .conftest import World


def noted(world: World, body: Callable[[Node], Any]) -> list[tuple[str, dict[str, Any]]]:
    """The facts that a program leaves."""

    def program() -> None:
        rclpy.init()
        elsewhere = rclpy.Context()
        rclpy.init(context=elsewhere)
        Node('server', context=elsewhere).create_service(Empty, '/spawn', lambda request, response: response)
        body(Node('node'))

    world.start(program)
    world.run(60)
    return [(kind, data) for kind, data in world.tracer.facts if 'name' in data]


def test_a_request_to_nobody_is_a_fact_once(world: World) -> None:
    def body(node: Node) -> None:
        client = node.create_client(Empty, '/spwan')
        client.call_async(Empty.Request())
        client.call_async(Empty.Request())

    ((kind, data),) = noted(world, body)
    assert (kind, data['node'], data['name'], data['kind']) == ('request lost', '/node', '/spwan', 'service')
    assert (data['file'], data['function']) == (__file__, 'body')


def test_a_goal_to_nobody_is_a_fact(world: World) -> None:
    ((kind, data),) = noted(world, lambda node: ActionClient(node, Fibonacci, 'count').send_goal_async(Fibonacci.Goal()))
    assert (kind, data['name'], data['kind']) == ('request lost', '/count', 'action')


def test_a_wait_of_a_second_is_a_fact(world: World) -> None:
    def body(node: Node) -> None:
        client = node.create_client(Empty, 'spawm')
        while not client.wait_for_service(1.0):
            if node.get_clock().now().nanoseconds > world.sim.start_ns + 40 * 10**9:
                return

    ((kind, data),) = noted(world, body)
    assert (kind, data['name'], data['calls']) == ('server awaited', '/spawm', 'client.wait_for_service')


def test_a_server_that_comes_in_time_is_no_news(world: World) -> None:
    def body(node: Node) -> None:
        world.start(late, name='late')
        client = node.create_client(Empty, 'late')
        client.wait_for_service()
        client.call_async(Empty.Request())

    def late() -> None:
        rclpy.init()
        from edulaunch.engine.sim.sync import sleep

        sleep(5)
        rclpy.spin(node_with_service())

    def node_with_service() -> Node:
        node = Node('late')
        node.create_service(Empty, 'late', lambda request, response: response)
        return node

    assert noted(world, body) == []
