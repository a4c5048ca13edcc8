import math
import rclpy
from rclpy.node import Node
from geometry_msgs.msg import TransformStamped
from tf2_ros import TransformBroadcaster
from turtlesim.msg import Pose


class Caster(Node):
    def __init__(self):
        super().__init__('caster')
        self.br = TransformBroadcaster(self)
        self.create_subscription(Pose, 'turtle1/pose', self.on_pose, 10)

    def on_pose(self, p):
        t = TransformStamped()
        t.header.stamp = self.get_clock().now().to_msg()
        t.header.frame_id = 'world'
        t.child_frame_id = 'turtle1'
        t.transform.translation.x = p.x
        t.transform.translation.y = p.y
        t.transform.rotation.z = math.sin(p.theta / 2)
        t.transform.rotation.w = math.cos(p.theta / 2)
        self.br.sendTransform(t)


def main(args=None):
    rclpy.init(args=args)
    node = Caster()
    rclpy.spin(node)
    rclpy.shutdown()


if __name__ == '__main__':
    main()
