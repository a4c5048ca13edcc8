import rclpy
from geometry_msgs.msg import Twist
from rclpy.duration import Duration
from rclpy.node import Node


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.publisher = self.create_publisher(Twist, '/turtle1/cmd_vel', 10)
        self.start = self.get_clock().now()
        self.create_timer(0.5, self.drive)

    def drive(self):
        command = Twist()
        command.linear.x = 1.0
        if self.get_clock().now() - self.start > 3.0:
            command.angular.z = 1.0
        self.publisher.publish(command)


def main():
    rclpy.init()
    rclpy.spin(Driver())
