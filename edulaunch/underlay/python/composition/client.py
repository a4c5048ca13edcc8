"""The component composition::Client."""

from __future__ import annotations

from typing import Any

from example_interfaces.srv import AddTwoInts
from rclcpp_like import CppNode


class Client(CppNode):
    """Asks `add_two_ints` for 2 + 3 every two seconds."""

    def __init__(self, **options: Any) -> None:
        super().__init__('Client', **options)
        self._client = self.create_client(AddTwoInts, 'add_two_ints')
        self._timer = self.create_wall_timer(2.0, self._on_timer)

    def _on_timer(self) -> None:
        if not self._client.service_is_ready():
            self.get_logger().info('Waiting for service to appear...')
            return
        self._client.call_async(AddTwoInts.Request(a=2, b=3)).add_done_callback(self._on_answer)

    def _on_answer(self, future: Any) -> None:
        self.get_logger().info(f'Got result: [{future.result().sum}]')
