import rclpy
from rclpy.node import Node


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.publishers_ = []


rclpy.init()
Robot()
