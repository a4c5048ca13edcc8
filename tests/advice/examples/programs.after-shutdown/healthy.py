import rclpy
from rclpy.node import Node

rclpy.init()
node = Node('robot')
node.create_timer(0.1, lambda: None)
rclpy.spin_once(node)
rclpy.shutdown()
