import rclpy
from rclpy.node import Node


class Walker(Node):
    def __init__(self):
        super().__init__('walker')
        self.create_timer(1.0, self.tick())

    def tick(self):
        self.get_logger().info('tick')


def main():
    rclpy.init()
    rclpy.spin(Walker())


main()
