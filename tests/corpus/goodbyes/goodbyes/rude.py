import rclpy
from rclpy.node import Node


def main(args=None):
    rclpy.init(args=args)
    node = Node('rude')
    rclpy.spin(node)
    print('never printed')
    rclpy.shutdown()
