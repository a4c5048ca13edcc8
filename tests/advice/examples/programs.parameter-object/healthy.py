import rclpy
from rclpy.node import Node


class Walker(Node):
    def __init__(self):
        super().__init__('walker')
        self.declare_parameter('speed', 1.0)
        self.twice = self.get_parameter('speed').value * 2
        self.create_timer(1.0, lambda: None)


def main():
    rclpy.init()
    rclpy.spin(Walker())


main()
