import message_filters
import rclpy
from message_filters import ApproximateTimeSynchronizer, Subscriber
from rclpy.node import Node
from sensor_msgs.msg import Image, LaserScan


class Pair(Node):
    def __init__(self):
        super().__init__('pair')
        image = Subscriber(self, Image, 'image')
        scan = Subscriber(self, LaserScan, 'scan', qos_profile=5)
        self.ts = ApproximateTimeSynchronizer([image, scan], queue_size=10, slop=0.1)
        self.ts.registerCallback(self.near)
        self.exact = message_filters.TimeSynchronizer([image, scan], 10)
        self.exact.registerCallback(self.same)

    def near(self, image, scan):
        self.get_logger().info('near %d %d' % (image.header.stamp.nanosec // 10**6, scan.header.stamp.nanosec // 10**6))

    def same(self, image, scan):
        self.get_logger().info('same %d' % (image.header.stamp.nanosec // 10**6))


def main():
    rclpy.init()
    rclpy.spin(Pair())
