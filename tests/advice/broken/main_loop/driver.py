import time

import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node
from turtlesim.msg import Pose


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.publisher = self.create_publisher(Twist, '/turtle1/cmd_vel', 10)
        self.create_subscription(Pose, '/turtle1/pose', self.on_pose, 10)
        self.x = 0.0

    def on_pose(self, pose):
        self.x = pose.x

    def drive(self):
        msg = Twist()
        msg.linear.x = 1.0
        msg.angular.z = 0.8
        self.publisher.publish(msg)


def main():
    rclpy.init()
    node = Driver()
    while rclpy.ok():
        if node.x < 9.0:
            node.drive()
        time.sleep(0.1)
    rclpy.shutdown()


if __name__ == '__main__':
    main()
