"""The programs add_two_ints_server, add_two_ints_client and add_two_ints_client_async. The clients request 2 + 3."""

from __future__ import annotations

from typing import Any

import rclpy
from example_interfaces.srv import AddTwoInts
from rclpy.client import Client
from rclpy.node import Node

from edulaunch.ros.running import run, spin


class AddTwoIntsServer(Node):
    """Serves the service `add_two_ints`."""

    def __init__(self) -> None:
        super().__init__('add_two_ints_server')
        self._service = self.create_service(AddTwoInts, 'add_two_ints', self._on_request)

    def _on_request(self, request: Any, response: Any) -> Any:
        response.sum = request.a + request.b
        self.get_logger().info(f'Incoming request\na: {request.a} b: {request.b}')
        return response


def _client() -> tuple[Node, Client]:
    """Return a node and its client, when the client has found a server."""
    node = rclpy.create_node('add_two_ints_client')
    client = node.create_client(AddTwoInts, 'add_two_ints')
    while not client.wait_for_service(timeout_sec=1.0):
        print('service not available, waiting again...')
    return node, client


def _ask() -> None:
    """Send one request and wait for the reply."""
    node, client = _client()
    reply = client.call_async(AddTwoInts.Request(a=2, b=3))
    rclpy.spin_until_future_complete(node, reply)
    if reply.result() is not None:
        node.get_logger().info(f'Result of add_two_ints: {reply.result().sum}')
    else:
        node.get_logger().error(f'Exception while calling service: {reply.exception()!r}')
    node.destroy_node()


def _ask_async() -> None:
    """Send one request, and check for the reply after each turn of the executor."""
    node, client = _client()
    reply = client.call_async(AddTwoInts.Request(a=2, b=3))
    while rclpy.ok() and not reply.done():
        rclpy.spin_once(node)
    if reply.done():
        node.get_logger().info(f'Result of add_two_ints: {reply.result().sum}')
    node.destroy_node()


def add_two_ints_server() -> None:
    """Run the program whose service adds two numbers."""
    spin(AddTwoIntsServer)


def add_two_ints_client() -> None:
    """Send a request, and wait for the reply."""
    run(_ask)


def add_two_ints_client_async() -> None:
    """Send a request, and do other work until the reply arrives."""
    run(_ask_async)
