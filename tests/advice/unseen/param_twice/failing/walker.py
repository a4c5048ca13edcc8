import rclpy
from rclpy.node import Node


class Walker(Node):
    def __init__(self):
        super().__init__('walker')
        self.declare_parameter('speed', 1.0)
        self.declare_parameter('speed', 2.0)
        self.speed = self.get_parameter('speed').value
        self.create_timer(1.0, lambda: self.get_logger().info(str(self.speed)))


def main():
    rclpy.init()
    rclpy.spin(Walker())


main()
