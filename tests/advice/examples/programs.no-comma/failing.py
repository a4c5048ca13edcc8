import rclpy
from rclpy.node import Node


def main():
    rclpy.init()
    node = Node('drive')
    node.declare_parameter('speed' 1.0)
    rclpy.spin(node)


main()
