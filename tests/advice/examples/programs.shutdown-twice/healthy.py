import rclpy
from rclpy.node import Node

rclpy.init()
node = Node('robot')
rclpy.shutdown()
rclpy.try_shutdown()
