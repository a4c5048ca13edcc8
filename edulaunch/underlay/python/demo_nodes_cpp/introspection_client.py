"""The program introspection_client: asks for 2 + 3 twice a second, and publishes that as much as its parameter says."""

from __future__ import annotations

import sys
from typing import Any

import rclpy
from example_interfaces.srv import AddTwoInts
from rclcpp_like import CppNode, run_program

from demo_nodes_cpp._introspection import follow_parameter


class IntrospectionClient(CppNode):
    """One request at a time."""

    def __init__(self, **options: Any) -> None:
        super().__init__('introspection_client', **options)
        self._client = self.create_client(AddTwoInts, 'add_two_ints')
        self._waits = False
        follow_parameter(self, 'client_configure_introspection', self._client)
        self._timer = self.create_wall_timer(0.5, self._on_timer)

    def _on_timer(self) -> None:
        if self._waits or not self._client.service_is_ready():
            return
        self._waits = True
        self._client.call_async(AddTwoInts.Request(a=2, b=3)).add_done_callback(self._on_answer)

    def _on_answer(self, future: Any) -> None:
        self._waits = False
        self.get_logger().info(f'Result of add_two_ints: {future.result().sum}')


def main() -> None:
    """Run the program."""
    sys.exit(run_program(lambda: rclpy.spin(IntrospectionClient())))


if __name__ == '__main__':
    main()
