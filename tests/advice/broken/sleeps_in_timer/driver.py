import time

import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node
from turtlesim.msg import Pose


class Square(Node):
    def __init__(self):
        super().__init__('square')
        self.publisher = self.create_publisher(Twist, '/turtle1/cmd_vel', 10)
        self.create_subscription(Pose, '/turtle1/pose', self.on_pose, 10)
        self.create_timer(0.1, self.step)
        self.pose = None

    def on_pose(self, msg):
        self.pose = msg

    def step(self):
        self.send(1.0, 0.0)
        time.sleep(1.0)
        self.send(0.0, 1.57)
        time.sleep(1.0)

    def send(self, forward, turn):
        msg = Twist()
        msg.linear.x = forward
        msg.angular.z = turn
        self.publisher.publish(msg)


rclpy.init()
rclpy.spin(Square())
