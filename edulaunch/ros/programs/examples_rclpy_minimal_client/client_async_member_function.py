"""The program client_async_member_function: a class that sends a request."""

from __future__ import annotations

import rclpy
from rclpy.node import Node

from edulaunch.ros.running import run
from examples_rclpy_minimal_client._asking import REQUEST, client_of, tell


class MinimalClientAsync(Node):
    """A node with a client of `add_two_ints`. Its constructor waits for the server."""

    def __init__(self) -> None:
        super().__init__('minimal_client_async')
        self.cli = client_of(self)
        self.req = REQUEST

    def send_request(self) -> None:
        """Send the request. The reply arrives in `future`."""
        self.future = self.cli.call_async(self.req)


def ask() -> None:
    """Send one request, and log the reply."""
    node = MinimalClientAsync()
    node.send_request()
    while rclpy.ok() and not node.future.done():
        rclpy.spin_once(node)
    tell(node, node.req, node.future.result())


def main(args: list[str] | None = None) -> None:
    """Run the program."""
    run(ask, args)


if __name__ == '__main__':
    main()
