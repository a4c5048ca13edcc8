import rclpy
from rclpy.node import Node


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.create_timer(0.1, self.tick)

    def tick():
        pass


rclpy.init()
rclpy.spin_once(Robot())
