import rclpy
from rclpy.qos import qos_profile_sensor_data
from turtlesim.msg import Pose
from rclpy.node import Node


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.create_subscription(Pose, '/turtle1/pose', self.heard, qos_profile_sensor_data())

    def heard(self, message):
        self.last = message.x


def main():
    rclpy.init()
    rclpy.spin(Driver())
