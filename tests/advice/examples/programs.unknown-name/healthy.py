from math import cos

import rclpy
from rclpy.node import Node


class Circler(Node):
    def __init__(self):
        super().__init__('circler')
        self.create_timer(1.0, self.tick)

    def tick(self):
        self.get_logger().info(f'{cos(0.0):.1f}')


rclpy.init()
rclpy.spin_once(Circler())
