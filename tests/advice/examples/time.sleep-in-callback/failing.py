import time

import rclpy
from rclpy.node import Node


class Worker(Node):
    def __init__(self):
        super().__init__('worker')
        self.create_timer(0.1, self.look)
        self.create_timer(1.0, self.work)

    def look(self):
        pass

    def work(self):
        self.get_logger().info('working')
        time.sleep(0.8)


rclpy.init()
rclpy.spin(Worker())
