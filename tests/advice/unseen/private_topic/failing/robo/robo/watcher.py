import rclpy
from std_msgs.msg import String
from rclpy.node import Node


class Watcher(Node):
    def __init__(self):
        super().__init__('watcher')
        self.create_subscription(String, '/status', self.heard, 10)

    def heard(self, message):
        self.get_logger().info(message.data)


def main():
    rclpy.init()
    rclpy.spin(Watcher())
