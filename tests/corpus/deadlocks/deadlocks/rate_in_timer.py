import rclpy
from rclpy.node import Node


class Sleeper(Node):
    def __init__(self):
        super().__init__('sleeper')
        self.rate = self.create_rate(0.5)
        self.create_timer(1.0, self.on_timer)

    def on_timer(self):
        self.get_logger().info('going to sleep')
        self.rate.sleep()
        self.get_logger().info('slept')


def main():
    rclpy.init()
    rclpy.spin(Sleeper())
