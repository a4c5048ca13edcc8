import rclpy
from geometry_msgs.msg import Twist
from turtlesim.msg import Pose
from rclpy.node import Node


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.publisher = self.create_publisher(Twist, '/turtle1/cmd_vel', 10)
        self.create_subscription(Pose, '/turtle1/pose', self.heard, 10)

    def heard(self, message):
        command = Twist()
        command.linear.x = 0.1 * message.x
        command.angular.z = 1.0
        self.publisher.publish(command)


def main():
    rclpy.init()
    rclpy.spin(Driver())
