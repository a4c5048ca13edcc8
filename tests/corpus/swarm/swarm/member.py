import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node
from turtlesim.msg import Pose


class Member(Node):
    """Keeps as far up as its leader; everything it uses is in its own namespace but the leader's pose."""

    def __init__(self):
        super().__init__('member')
        self.declare_parameters('', [('number', 0), ('leader', 'turtle1')])
        number, leader = (p.value for p in self.get_parameters(['number', 'leader']))
        self.pub = self.create_publisher(Twist, 'cmd_vel', 10)
        self.create_subscription(Pose, 'pose', self.on_pose, 10)
        self.create_subscription(Pose, f'/{leader}/pose', self.on_leader, 10)
        self.pose = None
        self.get_logger().info(f'{self.get_fully_qualified_name()} is number {number}, drives {self.pub.topic_name}')

    def on_pose(self, msg):
        self.pose = msg

    def on_leader(self, leader):
        if self.pose is not None and abs(leader.y - self.pose.y) > 0.05:
            self.pub.publish(Twist(linear=Twist().linear.__class__(x=2.0 * (leader.y - self.pose.y))))
        elif self.pose is not None:
            self.get_logger().info('beside the leader', once=True)


def main(args=None):
    rclpy.init(args=args)
    rclpy.spin(Member())
