"""What both clients of add_two_ints do: wait for the service, ask for 2 + 3, say the sum."""

from __future__ import annotations

import rclpy
from example_interfaces.srv import AddTwoInts
from rclcpp_like import CppNode


def ask() -> int:
    """Ask once; the exit code is 0, or 1 when the answer never came."""
    node = CppNode('add_two_ints_client')
    client = node.create_client(AddTwoInts, 'add_two_ints')
    while not client.wait_for_service(timeout_sec=1.0):
        if not rclpy.ok():
            node.get_logger().error('Interrupted while waiting for the service. Exiting.')
            return 0
        node.get_logger().info('service not available, waiting again...')
    reply = client.call_async(AddTwoInts.Request(a=2, b=3))
    rclpy.spin_until_future_complete(node, reply)
    answer = reply.result()
    if answer is None:
        node.get_logger().error('Interrupted while waiting for response. Exiting.')
        return 1
    node.get_logger().info(f'Result of add_two_ints: {answer.sum}')
    return 0
