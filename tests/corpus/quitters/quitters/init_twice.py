import rclpy
from rclpy.node import Node


def main():
    rclpy.init()
    node = Node('first_life')
    node.create_timer(0.5, rclpy.shutdown)
    rclpy.spin(node)
    rclpy.init()
    node = Node('second_life')
    node.create_timer(0.5, lambda: node.get_logger().info('born again'))
    rclpy.spin_once(node)
    rclpy.init()
