"""The common parts of the clients: waiting for the service, the request, and the log line with the sum."""

from __future__ import annotations

from example_interfaces.srv import AddTwoInts
from rclpy.client import Client
from rclpy.node import Node

REQUEST = AddTwoInts.Request(a=41, b=1)


def client_of(node: Node) -> Client:
    """Wait for a server of `add_two_ints`, and return a client."""
    client = node.create_client(AddTwoInts, 'add_two_ints')
    while not client.wait_for_service(timeout_sec=1.0):
        node.get_logger().info('service not available, waiting again...')
    return client


def tell(node: Node, request: AddTwoInts.Request, response: AddTwoInts.Response) -> None:
    """Log the sum."""
    node.get_logger().info(f'Result of add_two_ints: for {request.a} + {request.b} = {response.sum}')
