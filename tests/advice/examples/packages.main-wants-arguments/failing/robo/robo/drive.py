import rclpy
from rclpy.node import Node


def main(args):
    rclpy.init(args=args)
    rclpy.spin(Node('drive'))
