import rclpy
from rclpy.node import Node
from turtlesim.msg import Pose


class Looker(Node):
    def __init__(self):
        super().__init__('looker')
        self.pose = None
        self.create_subscription(Pose, 'turtle1/pose', self.on_pose, 10)
        self.create_timer(0.01, self.on_timer)

    def on_pose(self, pose):
        self.pose = pose

    def on_timer(self):
        while self.pose is None:
            rclpy.spin_once(self)
        self.get_logger().info('x is %.1f' % self.pose.x)


def main():
    rclpy.init()
    rclpy.spin(Looker())
