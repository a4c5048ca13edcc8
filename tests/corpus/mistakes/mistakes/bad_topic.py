import rclpy
from rclpy.node import Node
from std_msgs.msg import String


def main():
    rclpy.init()
    Node('bad_topic').create_publisher(String, 'my topic', 10)
