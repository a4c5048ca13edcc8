import rclpy
from rclpy.node import Node

rclpy.init()
node = Node('robot')
corners = iter([1, 2])
node.create_timer(0.1, lambda: next(corners, None))
for _ in range(5):
    rclpy.spin_once(node)
