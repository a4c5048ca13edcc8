from rclpy.node import Node


def main():
    Node('too_early')
