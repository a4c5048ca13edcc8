import rclpy
from rclpy.node import Node
from tf_transformations import quaternion_from_euler
from geometry_msgs.msg import TransformStamped
from tf2_ros import TransformBroadcaster
from turtlesim.msg import Pose


class Frames(Node):

    def __init__(self):
        super().__init__('frames')
        self.declare_parameter('turtle', 'turtle1')
        self.turtle = self.get_parameter('turtle').value
        self.broadcaster = TransformBroadcaster(self)
        self.create_subscription(Pose, f'/{self.turtle}/pose', self.send, 10)

    def send(self, pose):
        t = TransformStamped()
        t.header.stamp = self.get_clock().now().to_msg()
        t.header.frame_id = 'world'
        t.child_frame_id = self.turtle
        t.transform.translation.x = pose.x
        t.transform.translation.y = pose.y
        q = quaternion_from_euler(0, 0, pose.theta)
        t.transform.rotation.x, t.transform.rotation.y = q[0], q[1]
        t.transform.rotation.z, t.transform.rotation.w = q[2], q[3]
        self.broadcaster.sendTransform(t)


def main(args=None):
    rclpy.init(args=args)
    node = Frames()
    rclpy.spin(node)
    rclpy.shutdown()


if __name__ == '__main__':
    main()
