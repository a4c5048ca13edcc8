import time
import rclpy
from rclpy import qos
from rclpy.node import Node
from rclpy.qos import QoSDurabilityPolicy, QoSHistoryPolicy, QoSProfile, QoSReliabilityPolicy
from std_msgs.msg import String


class Receiver(Node):
    def __init__(self):
        super().__init__('receiver')
        latched = QoSProfile(depth=1, durability=QoSDurabilityPolicy.TRANSIENT_LOCAL,
                             reliability=QoSReliabilityPolicy.RELIABLE, history=QoSHistoryPolicy.KEEP_LAST)
        self.subs = [
            self.create_subscription(String, 'map', self.log('latched'), latched),
            self.create_subscription(String, 'map', self.log('volatile'), 10),
            self.create_subscription(String, 'scan', self.log('reliable scan'), 10),
            self.create_subscription(String, 'scan', self.log('best effort scan'), qos.qos_profile_sensor_data),
            self.create_subscription(String, 'plain', self.log('plain'), latched),
            self.create_subscription(String, 'plain', self.log('plain best effort'),
                                     QoSProfile(depth=5, reliability=QoSReliabilityPolicy.BEST_EFFORT)),
        ]

    def log(self, name):
        return lambda msg: self.get_logger().info(name + ': ' + msg.data)


def main():
    rclpy.init()
    rclpy.spin(Receiver())
