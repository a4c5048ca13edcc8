from rclpy.node import Node
from tf2_ros import TransformBroadcaster
from turtlesim.msg import Pose

from learning_tf2_py.frames import placed, turned
from learning_tf2_py.program import run


class FramePublisher(Node):
    """Says where one turtle is, each time the simulator says so."""

    def __init__(self):
        super().__init__('turtle_tf2_frame_publisher')
        self.turtle = self.declare_parameter('turtlename', 'turtle').value
        self.broadcaster = TransformBroadcaster(self)
        self.create_subscription(Pose, f'/{self.turtle}/pose', self.on_pose, 1)

    def on_pose(self, pose):
        t = placed(self, 'world', self.turtle, pose.x, pose.y, 0.0, turned(0.0, 0.0, pose.theta))
        self.broadcaster.sendTransform(t)


def main():
    run(FramePublisher)
