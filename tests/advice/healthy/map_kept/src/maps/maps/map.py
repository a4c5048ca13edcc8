import rclpy
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from std_msgs.msg import String


KEPT = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


class Map(Node):
    def __init__(self):
        super().__init__('map')
        self.publisher = self.create_publisher(String, 'map', KEPT)
        self.publisher.publish(String(data='####'))


def main():
    rclpy.init()
    rclpy.spin(Map())
