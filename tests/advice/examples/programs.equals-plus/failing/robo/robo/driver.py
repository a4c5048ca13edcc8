import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.publisher = self.create_publisher(Twist, '/turtle1/cmd_vel', 10)
        self.count = 0
        self.create_timer(0.5, self.drive)

    def drive(self):
        self.count =+ 1
        command = Twist()
        command.linear.x = 0.1 * self.count if self.count < 10 else 0.5
        command.angular.z = 1.0
        self.publisher.publish(command)


def main():
    rclpy.init()
    rclpy.spin(Driver())
