import rclpy
from rclpy.node import Node

rclpy.init()
node = Node('counter')
steps = {}
node.get_logger().info(f'{len(steps)} steps')
