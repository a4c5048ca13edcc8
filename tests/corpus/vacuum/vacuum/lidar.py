"""A fake laser in a square room; the ranges are a numpy array, as Jazzy takes them."""
import numpy as np
import rclpy
from nav_msgs.msg import Odometry
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import LaserScan


class Lidar(Node):
    def __init__(self):
        super().__init__('lidar')
        self.half = self.declare_parameter('room', 4.0).value / 2
        self.n = self.declare_parameter('samples', 72).value
        self.pose = None
        self.pub = self.create_publisher(LaserScan, 'scan', qos_profile_sensor_data)
        self.create_subscription(Odometry, 'odom', self.on_odom, 10)
        self.create_timer(0.1, self.scan)

    def on_odom(self, msg):
        q = msg.pose.pose.orientation
        self.pose = (msg.pose.pose.position.x, msg.pose.pose.position.y, 2 * np.arctan2(q.z, q.w))

    def scan(self):
        if self.pose is None: return
        x, y, theta = self.pose
        angles = np.linspace(-np.pi, np.pi, self.n, endpoint=False) + theta
        c, s = np.cos(angles), np.sin(angles)
        with np.errstate(divide='ignore'):
            dx = np.where(c > 0, self.half - x, -self.half - x) / c
            dy = np.where(s > 0, self.half - y, -self.half - y) / s
        ranges = np.minimum(np.abs(dx), np.abs(dy))
        ranges[ranges > 2.0] = np.inf
        msg = LaserScan(angle_min=-np.pi, angle_increment=2 * np.pi / self.n, range_min=0.05, range_max=2.0)
        msg.header.stamp = self.get_clock().now().to_msg()
        msg.header.frame_id = 'laser'
        msg.angle_max = msg.angle_min + msg.angle_increment * (self.n - 1)
        msg.ranges = ranges.astype(np.float32)
        self.pub.publish(msg)


def main():
    rclpy.init()
    node = Lidar()
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        node.get_logger().info('bye')
