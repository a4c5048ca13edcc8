"""The program add_two_ints_client_async: asks for 2 + 3 and does other work until the reply is there."""

from __future__ import annotations

import rclpy
from example_interfaces.srv import AddTwoInts

from demo_nodes_py._running import run


def ask() -> None:
    """Ask once, look for the reply after each turn of the executor."""
    node = rclpy.create_node('add_two_ints_client')
    client = node.create_client(AddTwoInts, 'add_two_ints')
    while not client.wait_for_service(timeout_sec=1.0):
        print('service not available, waiting again...')
    reply = client.call_async(AddTwoInts.Request(a=2, b=3))
    while rclpy.ok() and not reply.done():
        rclpy.spin_once(node)
    if reply.done():
        node.get_logger().info(f'Result of add_two_ints: {reply.result().sum}')
    node.destroy_node()


def main() -> None:
    """Run the program until Ctrl-C or a shutdown."""
    run(ask)


if __name__ == '__main__':
    main()
