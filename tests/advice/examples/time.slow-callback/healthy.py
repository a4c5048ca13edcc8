import rclpy
from rclpy.node import Node


class Worker(Node):
    def __init__(self):
        super().__init__('worker')
        self.create_timer(0.1, self.work)

    def work(self):
        end = self.get_clock().now() + rclpy.duration.Duration(seconds=0.05)
        while self.get_clock().now() < end:
            pass


rclpy.init()
rclpy.spin(Worker())
