"""The program client_async_callback: it sends a request in a callback and waits for the reply with `await`."""

from __future__ import annotations

import rclpy
from rclpy.callback_groups import ReentrantCallbackGroup

from edulaunch.ros.running import run
from examples_rclpy_minimal_client._asking import REQUEST, client_of, tell


def ask() -> None:
    """Send one request half a second after the start. The callback group allows the reply to arrive while the callback
    waits for it.
    """
    node = rclpy.create_node('minimal_client')
    group = ReentrantCallbackGroup()
    steps: list[str] = []

    async def call_service() -> None:
        steps.append('asked')
        try:
            tell(node, REQUEST, await client.call_async(REQUEST))
        finally:
            steps.append('answered')

    client = client_of(node)
    timer = node.create_timer(0.5, call_service, callback_group=group)
    while rclpy.ok() and 'asked' not in steps:
        rclpy.spin_once(node)
    timer.cancel()
    while rclpy.ok() and 'answered' not in steps:
        rclpy.spin_once(node)


def main(args: list[str] | None = None) -> None:
    """Run the program."""
    run(ask, args)


if __name__ == '__main__':
    main()
