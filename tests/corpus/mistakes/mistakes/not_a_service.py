import rclpy
from rclpy.node import Node
from std_msgs.msg import String


def main():
    rclpy.init()
    Node('not_a_service').create_client(String, 'topic')
