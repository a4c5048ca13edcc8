import random
import rclpy
from rclpy.node import Node


def main(args=None):
    rclpy.init(args=args)
    Node('my_random').get_logger().info('1 to 1: %d' % random.randint(1, 1))
