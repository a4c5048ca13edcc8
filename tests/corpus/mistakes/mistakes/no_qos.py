import rclpy
from rclpy.node import Node
from std_msgs.msg import String


def main():
    rclpy.init()
    Node('no_qos').create_publisher(String, 'topic')
