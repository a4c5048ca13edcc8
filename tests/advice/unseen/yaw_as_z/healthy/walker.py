import rclpy
from rclpy.node import Node
import math
from geometry_msgs.msg import TransformStamped
from tf2_ros import TransformBroadcaster
from turtlesim.msg import Pose


class Walker(Node):
    def __init__(self):
        super().__init__('walker')
        self.broadcaster = TransformBroadcaster(self)
        self.create_subscription(Pose, '/turtle1/pose', self.see, 10)

    def see(self, message):
        t = TransformStamped()
        t.header.stamp = self.get_clock().now().to_msg()
        t.header.frame_id = 'world'
        t.child_frame_id = 'turtle1'
        t.transform.translation.x = message.x
        t.transform.translation.y = message.y
        t.transform.rotation.z = math.sin(message.theta / 2)
        t.transform.rotation.w = math.cos(message.theta / 2)
        self.broadcaster.sendTransform(t)


def main():
    rclpy.init()
    node = Walker()
    rclpy.spin(node)
    rclpy.shutdown()


main()
