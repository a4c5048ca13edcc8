"""The program add_two_ints_client: asks for 2 + 3 and waits for the reply."""

from __future__ import annotations

import rclpy
from example_interfaces.srv import AddTwoInts

from demo_nodes_py._running import run


def ask() -> None:
    """Ask once."""
    node = rclpy.create_node('add_two_ints_client')
    client = node.create_client(AddTwoInts, 'add_two_ints')
    while not client.wait_for_service(timeout_sec=1.0):
        print('service not available, waiting again...')
    reply = client.call_async(AddTwoInts.Request(a=2, b=3))
    rclpy.spin_until_future_complete(node, reply)
    if reply.result() is not None:
        node.get_logger().info(f'Result of add_two_ints: {reply.result().sum}')
    else:
        node.get_logger().error(f'Exception while calling service: {reply.exception()!r}')
    node.destroy_node()


def main() -> None:
    """Run the program until Ctrl-C or a shutdown."""
    run(ask)


if __name__ == '__main__':
    main()
