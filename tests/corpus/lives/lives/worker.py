import rclpy
from rclpy.node import Node


def main():
    rclpy.init()
    node = Node('worker')
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        node.get_logger().info('going home')
        node.destroy_node()
