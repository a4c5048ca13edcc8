import rclpy
from rclpy.node import Node


class Mayfly(Node):
    def __init__(self):
        super().__init__('mayfly')
        self.get_logger().info('born')
        self.create_timer(0.7, self.die)

    def die(self):
        raise RuntimeError('short life')


def main():
    rclpy.init()
    rclpy.spin(Mayfly())
