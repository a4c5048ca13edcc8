import rclpy
from rclpy.node import Node


def main(args=None):
    rclpy.init(args=args)
    rclpy.spin(Node('drive'))
