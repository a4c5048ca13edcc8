import rclpy
from rclpy.node import Node


def main(args=None):
    rclpy.init(args=args)
    node = Node('undeclared')
    node.declare_parameter('speed', 1.0)
    print(node.get_parameter('speed').value)
    print(node.get_parameter('sped').value)
