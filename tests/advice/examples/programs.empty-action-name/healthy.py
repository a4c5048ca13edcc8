import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionClient, ActionServer
from rclpy.node import Node

rclpy.init()
node = Node('robot')
server = ActionServer(node, Fibonacci, 'count', lambda goal: Fibonacci.Result())
client = ActionClient(node, Fibonacci, 'count')
rclpy.spin_once(node, timeout_sec=0.1)
