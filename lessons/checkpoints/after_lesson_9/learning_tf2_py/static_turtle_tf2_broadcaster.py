import sys

from rclpy.node import Node
from rclpy.utilities import remove_ros_args
from tf2_ros import StaticTransformBroadcaster

from learning_tf2_py.frames import placed, turned
from learning_tf2_py.program import run


class StaticFramePublisher(Node):
    """Publishes once where the frame `child` is relative to world."""

    def __init__(self, child, x, y, z, roll, pitch, yaw):
        super().__init__('static_turtle_tf2_broadcaster')
        self.broadcaster = StaticTransformBroadcaster(self)
        t = placed(self, 'world', child, x, y, z, turned(roll, pitch, yaw))
        self.broadcaster.sendTransform(t)


def main():
    child, *numbers = remove_ros_args(sys.argv)[1:]
    run(lambda: StaticFramePublisher(child, *map(float, numbers)))
