import rclpy
from rclpy.node import Node
from std_srvs.srv import Empty


def main():
    rclpy.init()
    Node('message_class').create_publisher(Empty, 'topic', 10)
