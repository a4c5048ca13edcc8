"""The component composition::Server."""

from __future__ import annotations

from typing import Any

from example_interfaces.srv import AddTwoInts
from rclcpp_like import CppNode


class Server(CppNode):
    """Adds on `add_two_ints`."""

    def __init__(self, **options: Any) -> None:
        super().__init__('Server', **options)
        self._service = self.create_service(AddTwoInts, 'add_two_ints', self._on_request)

    def _on_request(self, request: Any, response: Any) -> Any:
        self.get_logger().info(f'Incoming request: [a: {request.a}, b: {request.b}]')
        response.sum = request.a + request.b
        return response
