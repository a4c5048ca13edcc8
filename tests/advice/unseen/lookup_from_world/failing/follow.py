import math

import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node
from rclpy.time import Time
from tf2_ros import Buffer, TransformException, TransformListener


class Follow(Node):
    def __init__(self):
        super().__init__('follow')
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.publisher = self.create_publisher(Twist, '/turtle2/cmd_vel', 10)
        self.create_timer(0.1, self.drive)

    def drive(self):
        try:
            found = self.buffer.lookup_transform('world', 'turtle1', Time())
        except TransformException:
            return
        message = Twist()
        message.angular.z = 1.0 * math.atan2(found.transform.translation.y, found.transform.translation.x)
        message.linear.x = 0.5 * math.hypot(found.transform.translation.x, found.transform.translation.y)
        self.publisher.publish(message)


def main():
    rclpy.init()
    rclpy.spin(Follow())


main()
