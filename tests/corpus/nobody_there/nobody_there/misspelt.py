import rclpy
from rclpy.node import Node
from turtlesim.srv import Spawn


def main():
    rclpy.init()
    node = Node('misspelt')
    client = node.create_client(Spawn, '/spwan')
    while not client.wait_for_service(timeout_sec=5.0):
        node.get_logger().info('service not available, waiting again...')
