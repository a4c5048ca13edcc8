import rclpy
from rclpy.node import Node


def main():
    rclpy.init()
    node = Node('healthy')
    node.create_timer(1.0, lambda: node.get_logger().info('still here'))
    rclpy.spin(node)
