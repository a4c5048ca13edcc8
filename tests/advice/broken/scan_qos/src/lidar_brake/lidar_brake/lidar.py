import rclpy
from rclpy.node import Node
from rclpy.qos import QoSProfile, ReliabilityPolicy
from sensor_msgs.msg import LaserScan


class Lidar(Node):
    def __init__(self):
        super().__init__('lidar')
        self.publisher = self.create_publisher(LaserScan, 'scan', QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT))
        self.create_timer(0.2, self.scan)

    def scan(self):
        self.publisher.publish(LaserScan(ranges=[1.0, 2.0]))


def main():
    rclpy.init()
    rclpy.spin(Lidar())
