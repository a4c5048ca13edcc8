import rclpy
from rclpy.node import Node

rclpy.init()
node = Node('robot')
node.get_logger().info(str(42))
