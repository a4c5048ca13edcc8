import rclpy
from rclpy.node import Node

rclpy.init()
rclpy.spin_once(Node('robot'), timeout_sec=0.1)
