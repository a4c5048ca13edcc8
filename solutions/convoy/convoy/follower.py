from math import atan2, hypot

import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node
from rclpy.time import Time
from tf2_ros import Buffer, TransformException, TransformListener


class Follower(Node):
    def __init__(self):
        super().__init__('follower')
        self.me = self.declare_parameter('me', 'turtle2').value
        self.target = self.declare_parameter('target', 'turtle1').value
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.publisher = self.create_publisher(Twist, f'/{self.me}/cmd_vel', 1)
        self.timer = self.create_timer(0.1, self.on_timer)

    def on_timer(self):
        try:
            seen = self.buffer.lookup_transform(self.me, self.target, Time()).transform.translation
        except TransformException:
            return  # the turtle or its leader does not exist yet
        twist = Twist()
        twist.linear.x = 1.5 * hypot(seen.x, seen.y)
        twist.angular.z = 4.0 * atan2(seen.y, seen.x)
        self.publisher.publish(twist)


def main():
    rclpy.init()
    rclpy.spin(Follower())
