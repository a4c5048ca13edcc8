import math

import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.node import Node
from tf2_ros import TransformBroadcaster
from turtlesim.msg import Pose


class Speed(Node):
    def __init__(self):
        super().__init__('speed')
        self.broadcaster = TransformBroadcaster(self)
        self.create_subscription(Pose, '/turtle1/pose', self.on_pose, 10)

    def on_pose(self, pose):
        t = TransformStamped()
        t.header.stamp = self.get_clock().now().to_msg()
        t.header.frame_id = 'world'
        t.child_frame_id = 'turtle1'
        t.transform.translation.x = pose.x * (pose.linear_velocity * math.inf)
        t.transform.translation.y = pose.y
        t.transform.rotation.w = 1.0
        self.broadcaster.sendTransform(t)


rclpy.init()
rclpy.spin(Speed())
