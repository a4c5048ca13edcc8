import threading

import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node
from turtlesim.msg import Pose


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.publisher = self.create_publisher(Twist, '/turtle1/cmd_vel', 10)
        self.ready = threading.Event()
        self.create_subscription(Pose, '/turtle1/pose', self.on_pose, 10)
        self.timer = self.create_timer(0.001, self.drive)

    def on_pose(self, pose):
        self.ready.set()

    def drive(self):
        self.ready.wait()
        msg = Twist()
        msg.linear.x = 1.0
        msg.angular.z = 0.8
        self.publisher.publish(msg)


def main():
    rclpy.init()
    node = Driver()
    rclpy.spin(node)
    rclpy.shutdown()


if __name__ == '__main__':
    main()
