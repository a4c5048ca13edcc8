import rclpy
from rclpy.node import Node


class Robot(Node):
    def __init__(self):
        super().__init__('robot')


rclpy.init()
rclpy.spin_once('robot', timeout_sec=0.1)
