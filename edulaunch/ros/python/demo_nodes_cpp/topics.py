"""The programs talker, listener and listener_best_effort, which use the topic `chatter`."""

from __future__ import annotations

from typing import Any

from rclcpp_like import CppNode, spinning
from rclpy.qos import QoSProfile, qos_profile_sensor_data
from std_msgs.msg import String


class Talker(CppNode):
    """Publishes greetings that are numbered from 1."""

    def __init__(self, **options: Any) -> None:
        super().__init__('talker', **options)
        self._number = 0
        self._chatter = self.create_publisher(String, 'chatter', 7)
        self._timer = self.create_wall_timer(1.0, self._on_timer)

    def _on_timer(self) -> None:
        self._number += 1
        message = String(data=f'Hello World: {self._number}')
        self.get_logger().info(f"Publishing: '{message.data}'")
        self._chatter.publish(message)


class Listener(CppNode):
    """Logs every message."""

    def __init__(self, qos: QoSProfile | int = 10, **options: Any) -> None:
        super().__init__('listener', **options)
        self._chatter = self.create_subscription(String, 'chatter', self._on_message, qos)

    def _on_message(self, message: String) -> None:
        self.get_logger().info(f'I heard: [{message.data}]')


class BestEffortListener(Listener):
    """Works like the listener, but with the reliability best effort."""

    def __init__(self, **options: Any) -> None:
        super().__init__(qos_profile_sensor_data, **options)


talker = spinning(Talker)
listener = spinning(Listener)
listener_best_effort = spinning(BestEffortListener)
