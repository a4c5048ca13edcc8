import rclpy
from rclpy.node import Node

rclpy.init()
node = Node('robot')
timer = node.create_timer(0.1, lambda: None)
rclpy.spin_once(node)
timer.destroy()
