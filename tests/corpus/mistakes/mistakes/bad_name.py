import rclpy
from rclpy.node import Node


def main():
    rclpy.init()
    Node('2nd_node')
