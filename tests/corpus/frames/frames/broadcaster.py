import math
import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.node import Node
from tf2_ros import TransformBroadcaster
from tf2_ros.static_transform_broadcaster import StaticTransformBroadcaster
import tf_transformations


class FramePublisher(Node):
    def __init__(self):
        super().__init__('frame_publisher')
        self.static = StaticTransformBroadcaster(self)
        self.moving = TransformBroadcaster(self)
        t = TransformStamped()
        t.header.stamp = self.get_clock().now().to_msg()
        t.header.frame_id = 'base_link'
        t.child_frame_id = 'laser'
        t.transform.translation.x = 0.5
        q = tf_transformations.quaternion_from_euler(0, 0, math.pi / 2)
        t.transform.rotation.x, t.transform.rotation.y = q[0], q[1]
        t.transform.rotation.z, t.transform.rotation.w = q[2], q[3]
        self.static.sendTransform(t)
        self.start = self.get_clock().now()
        self.timer = self.create_timer(0.1, self.move)

    def move(self):
        now = self.get_clock().now()
        age = (now - self.start).nanoseconds / 1e9
        t = TransformStamped()
        t.header.stamp = now.to_msg()
        t.header.frame_id = 'world'
        t.child_frame_id = 'base_link'
        t.transform.translation.x = age
        t.transform.rotation.w = 1.0
        self.moving.sendTransform(t)


def main():
    rclpy.init()
    rclpy.spin(FramePublisher())
