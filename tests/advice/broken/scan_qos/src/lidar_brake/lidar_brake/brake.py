import rclpy
from rclpy.node import Node
from sensor_msgs.msg import LaserScan


class Brake(Node):
    def __init__(self):
        super().__init__('brake')
        self.create_subscription(LaserScan, 'scan', self.on_scan, 10)

    def on_scan(self, msg):
        self.get_logger().info(f'nearest: {min(msg.ranges)}')


def main():
    rclpy.init()
    rclpy.spin(Brake())
