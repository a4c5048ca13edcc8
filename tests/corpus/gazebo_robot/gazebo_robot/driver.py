import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node
from sensor_msgs.msg import LaserScan


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.pub = self.create_publisher(Twist, 'cmd_vel', 10)
        self.create_subscription(LaserScan, 'scan', self.on_scan, 10)
        self.create_timer(1.0, self.tick)

    def on_scan(self, msg):
        self.get_logger().info('%.2f m' % min(msg.ranges))

    def tick(self):
        self.pub.publish(Twist())
        self.get_logger().info('driving blind')


def main():
    rclpy.init()
    rclpy.spin(Driver())
