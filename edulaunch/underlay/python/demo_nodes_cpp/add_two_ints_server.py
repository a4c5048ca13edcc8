"""The program add_two_ints_server: adds."""

from __future__ import annotations

import sys
from typing import Any

import rclpy
from example_interfaces.srv import AddTwoInts
from rclcpp_like import CppNode, run_program


class AddTwoIntsServer(CppNode):
    """Serves `add_two_ints`."""

    def __init__(self, **options: Any) -> None:
        super().__init__('add_two_ints_server', **options)
        self._service = self.create_service(AddTwoInts, 'add_two_ints', self._on_request)

    def _on_request(self, request: Any, response: Any) -> Any:
        self.get_logger().info(f'Incoming request\na: {request.a} b: {request.b}')
        response.sum = request.a + request.b
        return response


def main() -> None:
    """Run the program; its exit code is that of the original."""
    sys.exit(run_program(lambda: rclpy.spin(AddTwoIntsServer())))


if __name__ == '__main__':
    main()
