import time
from time import sleep
import rclpy
from rclpy.node import Node
from std_msgs.msg import Int64


class Slow(Node):
    def __init__(self, depth):
        super().__init__('slow')
        time.sleep(1.05)
        self.sub = self.create_subscription(Int64, 'number', self.on_number, depth)
        self.get_logger().info('ready')

    def on_number(self, msg):
        self.get_logger().info('got %d' % msg.data)
        sleep(1)


def main(args=None):
    rclpy.init(args=args)
    rclpy.spin(Slow(2))
