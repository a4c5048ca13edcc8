import math

import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.node import Node
from tf2_ros.static_transform_broadcaster import StaticTransformBroadcaster


class Moon(Node):
    def __init__(self):
        super().__init__('moon')
        self.broadcaster = StaticTransformBroadcaster(self)
        self.angle = 0.0
        self.create_timer(0.1, self.send)

    def send(self):
        self.angle += 0.1
        t = TransformStamped()
        t.header.stamp = self.get_clock().now().to_msg()
        t.header.frame_id = 'earth'
        t.child_frame_id = 'moon'
        t.transform.translation.x = 3 * math.cos(self.angle)
        t.transform.translation.y = 3 * math.sin(self.angle)
        t.transform.rotation.w = 1.0
        self.broadcaster.sendTransform(t)


rclpy.init()
rclpy.spin(Moon())
