"""The program add_two_ints_server: adds."""

from __future__ import annotations

from typing import Any

from example_interfaces.srv import AddTwoInts
from rclpy.node import Node

from demo_nodes_py._running import spin


class AddTwoIntsServer(Node):
    """Serves `add_two_ints`."""

    def __init__(self) -> None:
        super().__init__('add_two_ints_server')
        self._service = self.create_service(AddTwoInts, 'add_two_ints', self._on_request)

    def _on_request(self, request: Any, response: Any) -> Any:
        response.sum = request.a + request.b
        self.get_logger().info(f'Incoming request\na: {request.a} b: {request.b}')
        return response


def main() -> None:
    """Run the program until Ctrl-C or a shutdown."""
    spin(AddTwoIntsServer)


if __name__ == '__main__':
    main()
