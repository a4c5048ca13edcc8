"""Broadcasts where one turtle is in the world."""
from math import cos, sin

import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.node import Node
from tf2_ros import TransformBroadcaster
from turtlesim.msg import Pose


class Broadcaster(Node):
    def __init__(self):
        super().__init__('broadcaster')
        self.turtle = self.declare_parameter('turtlename', 'turtle1').value
        self.tf = TransformBroadcaster(self)
        self.subscription = self.create_subscription(Pose, f'/{self.turtle}/pose', self.on_pose, 10)

    def on_pose(self, pose):
        t = TransformStamped()
        t.header.stamp = self.get_clock().now().to_msg()
        t.header.frame_id = 'world'
        t.child_frame_id = self.turtle
        t.transform.translation.x = pose.x
        t.transform.translation.y = pose.y
        t.transform.rotation.z = sin(pose.theta / 2)
        t.transform.rotation.w = cos(pose.theta / 2)
        self.tf.sendTransform(t)


def main():
    rclpy.init()
    rclpy.spin(Broadcaster())
