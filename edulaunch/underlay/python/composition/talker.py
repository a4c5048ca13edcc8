"""The component composition::Talker."""

from __future__ import annotations

from typing import Any

from rclcpp_like import CppNode
from std_msgs.msg import String


class Talker(CppNode):
    """Greets on `chatter` every second, counting from 1."""

    def __init__(self, **options: Any) -> None:
        super().__init__('talker', **options)
        self._number = 0
        self._chatter = self.create_publisher(String, 'chatter', 10)
        self._timer = self.create_wall_timer(1.0, self._on_timer)

    def _on_timer(self) -> None:
        self._number += 1
        message = String(data=f'Hello World: {self._number}')
        self.get_logger().info(f"Publishing: '{message.data}'")
        self._chatter.publish(message)
