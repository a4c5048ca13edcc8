import rclpy
from rclpy.node import Node

rclpy.init()
node = Node('robot')
rclpy.shutdown()
node.get_clock()
node.create_timer(1.0, print)
