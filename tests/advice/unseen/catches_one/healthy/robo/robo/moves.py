import rclpy
from geometry_msgs.msg import TransformStamped
from tf2_ros import TransformBroadcaster
from rclpy.node import Node


class Moves(Node):
    def __init__(self):
        super().__init__('moves')
        self.broadcaster = TransformBroadcaster(self)
        self.create_timer(0.2, self.send)

    def send(self):
        transform = TransformStamped()
        transform.header.stamp = self.get_clock().now().to_msg()
        transform.header.frame_id = 'base'
        transform.child_frame_id = 'laser'
        transform.transform.rotation.w = 1.0
        self.broadcaster.sendTransform(transform)


def main():
    rclpy.init()
    rclpy.spin(Moves())
