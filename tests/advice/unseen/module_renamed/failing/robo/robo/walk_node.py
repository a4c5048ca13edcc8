import rclpy
from rclpy.node import Node
from geometry_msgs.msg import Twist


class Walker(Node):
    def __init__(self):
        super().__init__('walker')
        self.publisher = self.create_publisher(Twist, '/turtle1/cmd_vel', 10)
        self.create_timer(0.5, self.drive)

    def drive(self):
        message = Twist()
        message.linear.x = 0.5
        message.angular.z = 1.0
        self.publisher.publish(message)


def main():
    rclpy.init()
    node = Walker()
    rclpy.spin(node)
    rclpy.shutdown()

