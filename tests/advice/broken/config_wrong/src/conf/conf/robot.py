import rclpy
from rclpy.node import Node


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.declare_parameter('max_speed', 1.0)
        self.create_timer(1.0, self.tell)

    def tell(self):
        self.get_logger().info(f"max speed {self.get_parameter('max_speed').value}")


def main():
    rclpy.init()
    rclpy.spin(Robot())
