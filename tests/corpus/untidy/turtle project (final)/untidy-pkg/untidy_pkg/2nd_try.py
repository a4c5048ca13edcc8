import rclpy
from rclpy.node import Node


def main(args=None):
    rclpy.init(args=args)
    Node('second_try').get_logger().info('a module whose name is no identifier')
