import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Map(Node):
    def __init__(self):
        super().__init__('map')
        self.publisher = self.create_publisher(String, 'map', 1)
        self.publisher.publish(String(data='####'))


def main():
    rclpy.init()
    rclpy.spin(Map())
