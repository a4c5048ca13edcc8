import rclpy
from rclpy.node import Node


def main()
    rclpy.init()
    node = Node('drive')
    node.get_logger().info('ready')
    rclpy.spin(node)


main()
