import rclpy
from rclpy.node import Node

rclpy.init()
node = Node('robot')
node.destroy_node()
node.get_topic_names_and_types()
