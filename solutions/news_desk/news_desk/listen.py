"""Logs every message that it receives."""
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Listen(Node):
    def __init__(self):
        super().__init__('listen')
        self.subscription = self.create_subscription(String, 'greeting', self.on_greeting, 10)

    def on_greeting(self, message):
        self.get_logger().info(f'I heard: {message.data}')


def main():
    rclpy.init()
    rclpy.spin(Listen())
