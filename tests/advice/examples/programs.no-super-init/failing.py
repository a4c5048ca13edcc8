import rclpy
from rclpy.node import Node


class Robot(Node):
    def __init__(self):
        self.timer = self.create_timer(1.0, self.tick)

    def tick(self):
        pass


rclpy.init()
rclpy.spin_once(Robot())
