import math

import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.node import Node
from tf2_ros import TransformBroadcaster
from turtlesim.msg import Pose


class Broadcaster(Node):
    def __init__(self):
        super().__init__('broadcaster')
        self.name = self.declare_parameter('turtle', 'turtle1').value
        self.broadcaster = TransformBroadcaster(self)
        self.create_subscription(Pose, f'/{self.name}/pose', self.on_pose, 10)

    def on_pose(self, message):
        transform = TransformStamped()
        transform.header.stamp = self.get_clock().now().to_msg()
        transform.header.frame_id = 'world'
        transform.child_frame_id = self.name
        transform.transform.translation.x = message.x
        transform.transform.translation.y = message.y
        transform.transform.rotation.z = math.sin(message.theta / 2)
        transform.transform.rotation.w = math.cos(message.theta / 2)
        self.broadcaster.sendTransform(transform)


def main():
    rclpy.init()
    node = Broadcaster()
    rclpy.spin(node)
    rclpy.shutdown()


if __name__ == '__main__':
    main()
