import rclpy
from rclpy.node import Node
from std_srvs.srv import Empty


def main():
    rclpy.init()
    Node('class_for_object').create_client(Empty, 'clear').call_async(Empty.Request)
