import rclpy
from rclpy.node import Node

rclpy.init()
node = Node('robot')
print(node.get_publisher_names_and_types_by_node('robbot', '/'))
