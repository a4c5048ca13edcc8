import rclpy
from rclpy.node import Node


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.create_timer(0.5, self.handle)

    def handle(self):
        self.get_logger().info('still here')


rclpy.init()
rclpy.spin_once(Robot())
