"""The program client: it spins until its reply has arrived."""

from __future__ import annotations

import rclpy

from edulaunch.ros.running import run
from examples_rclpy_minimal_client._asking import REQUEST, client_of, tell


def ask() -> None:
    """Send one request, and spin until the reply has arrived."""
    node = rclpy.create_node('minimal_client')
    future = client_of(node).call_async(REQUEST)
    rclpy.spin_until_future_complete(node, future)
    tell(node, REQUEST, future.result())


def main(args: list[str] | None = None) -> None:
    """Run the program."""
    run(ask, args)


if __name__ == '__main__':
    main()
