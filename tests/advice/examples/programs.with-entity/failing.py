import rclpy
from rclpy.node import Node

rclpy.init()
node = Node('robot')
with node.create_timer(1.0, print):
    pass
