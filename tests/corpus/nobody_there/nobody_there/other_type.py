import rclpy
from rclpy.node import Node
from std_srvs.srv import Trigger


def main():
    rclpy.init()
    node = Node('other_type')
    client = node.create_client(Trigger, '/clear')
    print('there:', client.wait_for_service(timeout_sec=11.0))
