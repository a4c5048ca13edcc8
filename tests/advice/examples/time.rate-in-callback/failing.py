import rclpy
from rclpy.node import Node


class Counter(Node):
    def __init__(self):
        super().__init__('counter')
        self.count = 0
        self.rate = self.create_rate(10)
        self.create_timer(0.5, self.step)

    def step(self):
        while self.count < 10:
            self.count += 1
            self.rate.sleep()


rclpy.init()
rclpy.spin(Counter())
