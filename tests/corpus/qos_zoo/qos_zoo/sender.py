import rclpy
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, HistoryPolicy, QoSProfile, ReliabilityPolicy, qos_profile_sensor_data
from std_msgs.msg import String


class Sender(Node):
    def __init__(self):
        super().__init__('sender')
        latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.map_pub = self.create_publisher(String, 'map', latched)
        self.map_pub.publish(String(data='old map'))
        self.map_pub.publish(String(data='the map'))
        self.scan_pub = self.create_publisher(String, 'scan', qos_profile_sensor_data)
        self.plain_pub = self.create_publisher(String, 'plain', 10)
        self.plain_pub.publish(String(data='lost'))
        self.n = 0
        self.create_timer(1.0, self.tick)

    def tick(self):
        self.n += 1
        self.scan_pub.publish(String(data='scan %d' % self.n))
        self.plain_pub.publish(String(data='plain %d' % self.n))


def main():
    rclpy.init()
    rclpy.spin(Sender())
