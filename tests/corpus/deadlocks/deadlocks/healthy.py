import rclpy
from rclpy.node import Node


class Heart(Node):
    def __init__(self):
        super().__init__('heart')
        self.create_timer(1.5, lambda: self.get_logger().info('beat'))


def main():
    rclpy.init()
    rclpy.spin(Heart())
