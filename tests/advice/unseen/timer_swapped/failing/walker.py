import rclpy
from rclpy.node import Node


class Walker(Node):
    def __init__(self):
        super().__init__('walker')
        self.create_timer(self.tick, 1.0)

    def tick(self):
        self.get_logger().info('tick')


def main():
    rclpy.init()
    rclpy.spin(Walker())


main()
