import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node

rclpy.init()
executor = SingleThreadedExecutor()
executor.add_node(Node('robot'))
executor.shutdown()
