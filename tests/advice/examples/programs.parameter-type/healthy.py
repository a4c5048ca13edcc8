import rclpy
from rclpy.node import Node

rclpy.init(args=['--ros-args', '-p', 'speed:=2.0'])
node = Node('robot')
print(node.declare_parameter('speed', 1.0).value)
