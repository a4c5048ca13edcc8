import math

import rclpy
from rclpy.node import Node


class Distance(Node):
    def __init__(self):
        super().__init__('distance')
        self.x, self.y = 3.0, 4.0
        self.create_timer(0.5, self.check)

    def distance_to(self, x, y):
        distance = math.hypot(x - self.x, y - self.y)

    def check(self):
        left = self.distance_to(0.0, 0.0)
        if left < 0.5:
            self.get_logger().info('arrived')


def main():
    rclpy.init()
    rclpy.spin(Distance())


if __name__ == '__main__':
    main()
