"""The program client_async: between other work, it checks whether the reply has arrived."""

from __future__ import annotations

import rclpy

from edulaunch.ros.running import run
from examples_rclpy_minimal_client._asking import REQUEST, client_of, tell


def ask() -> None:
    """Send one request, and check for the reply after each spin."""
    node = rclpy.create_node('minimal_client_async')
    future = client_of(node).call_async(REQUEST)
    while rclpy.ok() and not future.done():
        rclpy.spin_once(node)
    try:
        tell(node, REQUEST, future.result())
    except Exception as error:
        node.get_logger().info(f'Service call failed {error!r}')


def main(args: list[str] | None = None) -> None:
    """Run the program."""
    run(ask, args)


if __name__ == '__main__':
    main()
