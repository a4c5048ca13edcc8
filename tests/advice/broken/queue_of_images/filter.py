import rclpy
from rclpy.node import Node
from turtlesim.msg import Pose


class Filter(Node):
    def __init__(self):
        super().__init__('filter')
        self.create_subscription(Pose, '/turtle1/pose', self.on_pose, 10)

    def on_pose(self, pose):
        end = self.get_clock().now().nanoseconds + 300_000_000
        while self.get_clock().now().nanoseconds < end:
            pass


rclpy.init()
rclpy.spin(Filter())
