import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.declare_parameter('speed', 1.0)
        self.declare_parameter('enabled', True)
        self.declare_parameter('route', [0.5, 1.0])
        self.publisher = self.create_publisher(Twist, '/turtle1/cmd_vel', 10)
        self.create_timer(0.5, self.drive)

    def drive(self):
        command = Twist()
        command.angular.z = sum(self.get_parameter('route').value)
        if self.get_parameter('enabled').value:
            command.linear.x = self.get_parameter('speed').value
        self.publisher.publish(command)


def main():
    rclpy.init()
    rclpy.spin(Driver())
