import math

import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node
from tf2_ros import Buffer, TransformException, TransformListener
from turtlesim.srv import Spawn


class Follower(Node):
    def __init__(self):
        super().__init__('follower')
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.publisher = self.create_publisher(Twist, '/turtle2/cmd_vel', 10)
        self.client = self.create_client(Spawn, '/spawn')
        self.client.wait_for_service()
        self.client.call_async(Spawn.Request(x=4.0, y=2.0, theta=0.0, name='turtle2'))
        self.create_timer(0.1, self.follow)

    def follow(self):
        try:
            seen = self.buffer.lookup_transform('turtle2', 'turtle1', rclpy.time.Time())
        except TransformException:
            return
        x, y = seen.transform.translation.x, seen.transform.translation.y
        message = Twist()
        message.linear.x = 0.5 * math.hypot(x, y)
        message.angular.z = math.atan2(y, x)
        self.publisher.publish(message)


def main():
    rclpy.init()
    node = Follower()
    rclpy.spin(node)
    rclpy.shutdown()


if __name__ == '__main__':
    main()
