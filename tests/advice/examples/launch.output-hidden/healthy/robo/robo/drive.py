import rclpy
from rclpy.node import Node


def main(args=None):
    rclpy.init(args=args)
    print('the battery is low', flush=True)
    rclpy.spin(Node('drive'))
