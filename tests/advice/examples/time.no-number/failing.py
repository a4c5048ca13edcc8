import rclpy
from rclpy.duration import Duration
from rclpy.node import Node

rclpy.init()
node = Node('late')
before = node.get_clock().now() - 0.5
node.get_logger().info(f'{before.nanoseconds}')
