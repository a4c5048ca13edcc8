import rclpy
from rclpy.node import Node

rclpy.init()
node = Node('robot')
node.declare_parameter('max_speed', 1.0)
print(node.get_parameter('max_speed').value)
