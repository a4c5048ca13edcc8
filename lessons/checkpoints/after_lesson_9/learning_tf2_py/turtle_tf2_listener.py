from geometry_msgs.msg import Twist
from rclpy.node import Node

from learning_tf2_py.program import run
from learning_tf2_py.steering import steer
from learning_tf2_py.watching import FrameWatcher


class FrameListener(Node):
    def __init__(self):
        super().__init__('turtle_tf2_frame_listener')
        self.target = self.declare_parameter('target_frame', 'turtle1').value
        self.watcher = FrameWatcher(self)
        self.publisher = self.create_publisher(Twist, 'turtle2/cmd_vel', 1)
        self.create_timer(1.0, self.on_timer)

    def on_timer(self):
        goal = self.watcher.find(self.target, seen_from='turtle2')
        if goal is not None:
            self.publisher.publish(steer(goal.x, goal.y))


def main():
    run(FrameListener)
