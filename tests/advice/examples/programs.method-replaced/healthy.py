import rclpy
from rclpy.node import Node


class Counter(Node):
    def __init__(self):
        super().__init__('counter')
        self.number = 0
        self.create_timer(0.5, self.count)

    def count(self):
        self.get_logger().info('tick')


rclpy.init()
rclpy.spin(Counter())
