"""The two ends of `chatter`."""

from __future__ import annotations

from rclpy.node import Node
from rclpy.qos import QoSProfile
from std_msgs.msg import String

PERIOD_S = 1.0


class Talker(Node):
    """Greets every second, counting from 0."""

    def __init__(self, node_name: str = 'talker', qos: QoSProfile | int = 10) -> None:
        super().__init__(node_name)
        self.count = 0
        self._chatter = self.create_publisher(String, 'chatter', qos)
        self._timer = self.create_timer(PERIOD_S, self._on_timer)

    def _on_timer(self) -> None:
        message = String(data=f'Hello World: {self.count}')
        self.count += 1
        self.get_logger().info(f'Publishing: "{message.data}"')
        self._chatter.publish(message)


class Listener(Node):
    """Logs what it hears."""

    def __init__(self, node_name: str = 'listener', qos: QoSProfile | int = 10) -> None:
        super().__init__(node_name)
        self.count = 0
        self._chatter = self.create_subscription(String, 'chatter', self._on_message, qos)

    def _on_message(self, message: String) -> None:
        self.count += 1
        self.get_logger().info(f'I heard: [{message.data}]')
