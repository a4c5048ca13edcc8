import rclpy
from rclpy.node import Node

rclpy.init()
node = Node('robot')
rclpy.spin_once(node, timeout_sec=0.5)
