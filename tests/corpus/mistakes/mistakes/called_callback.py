import rclpy
from rclpy.node import Node


class Eager(Node):
    def __init__(self):
        super().__init__('eager')
        self.timer = self.create_timer(1.0, self.tick())

    def tick(self):
        print('tick')


def main():
    rclpy.init()
    rclpy.spin(Eager())
