import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.declare_parameter('speed', 1.0)
        self.publisher = self.create_publisher(Twist, '/turtle1/cmd_vel', 10)
        self.create_timer(0.5, self.drive)

    def drive(self):
        command = Twist()
        command.linear.x = self.get_parameter('speed').value
        command.angular.z = 1.0
        self.publisher.publish(command)


def main():
    rclpy.init()
    rclpy.spin(Driver())
