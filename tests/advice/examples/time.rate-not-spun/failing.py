import rclpy
from rclpy.node import Node


class Counter(Node):
    def __init__(self):
        super().__init__('counter')
        self.count = 0
        rate = self.create_rate(2)
        while rclpy.ok():
            self.count += 1
            rate.sleep()


rclpy.init()
rclpy.spin(Counter())
