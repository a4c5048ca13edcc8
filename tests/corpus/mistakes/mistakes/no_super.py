import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Lazy(Node):
    def __init__(self):
        self.pub = self.create_publisher(String, 'topic', 10)


def main():
    rclpy.init()
    Lazy()
