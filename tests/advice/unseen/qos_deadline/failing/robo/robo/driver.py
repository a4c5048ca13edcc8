import rclpy
from rclpy.duration import Duration
from rclpy.qos import QoSProfile
from turtlesim.msg import Pose
from rclpy.node import Node


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.create_subscription(Pose, '/turtle1/pose', self.heard, QoSProfile(depth=10, deadline=Duration(seconds=0.1)))

    def heard(self, message):
        self.last = message.x


def main():
    rclpy.init()
    rclpy.spin(Driver())
