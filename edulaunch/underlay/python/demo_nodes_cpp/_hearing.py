"""A node that says what it hears on `chatter`."""

from __future__ import annotations

from typing import Any

from rclcpp_like import CppNode
from rclpy.qos import QoSProfile
from std_msgs.msg import String


class Listener(CppNode):
    """Logs every message."""

    def __init__(self, node_name: str, qos: QoSProfile | int, **options: Any) -> None:
        super().__init__(node_name, **options)
        self._chatter = self.create_subscription(String, 'chatter', self._on_message, qos)

    def _on_message(self, message: String) -> None:
        self.get_logger().info(f'I heard: [{message.data}]')
