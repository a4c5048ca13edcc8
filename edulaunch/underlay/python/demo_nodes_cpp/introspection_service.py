"""The program introspection_service: adds, and publishes what it is asked as much as its parameter says."""

from __future__ import annotations

import sys
from typing import Any

import rclpy
from example_interfaces.srv import AddTwoInts
from rclcpp_like import CppNode, run_program

from demo_nodes_cpp._introspection import follow_parameter


class IntrospectionService(CppNode):
    """Serves `add_two_ints`."""

    def __init__(self, **options: Any) -> None:
        super().__init__('introspection_service', **options)
        service = self.create_service(AddTwoInts, 'add_two_ints', self._on_request)
        follow_parameter(self, 'service_configure_introspection', service)

    def _on_request(self, request: Any, response: Any) -> Any:
        self.get_logger().info(f'Incoming request\na: {request.a} b: {request.b}')
        response.sum = request.a + request.b
        return response


def main() -> None:
    """Run the program."""
    sys.exit(run_program(lambda: rclpy.spin(IntrospectionService())))


if __name__ == '__main__':
    main()
