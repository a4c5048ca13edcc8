"""The program turtle_tf2_broadcaster: says where a turtle is, as the transform world -> turtle."""

from __future__ import annotations

from math import cos, sin

from demo_nodes_py._running import spin
from geometry_msgs.msg import TransformStamped
from rclpy.constants import S_TO_NS
from rclpy.node import Node
from tf2_ros import TransformBroadcaster
from turtlesim.msg import Pose


class FramePublisher(Node):
    """One transform for each pose of the turtle named by the parameter `turtlename`."""

    def __init__(self) -> None:
        super().__init__('turtle_tf2_frame_publisher')
        self._turtle = self.declare_parameter('turtlename', 'turtle').get_parameter_value().string_value
        self._clock = self.get_clock()
        self._broadcaster = TransformBroadcaster(self)
        self._poses = self.create_subscription(Pose, f'/{self._turtle}/pose', self._on_pose, 1)
        self._transform = TransformStamped()
        self._transform.header.frame_id = 'world'
        self._transform.child_frame_id = self._turtle
        self._stamp = self._transform.header.stamp
        self._translation = self._transform.transform.translation
        self._rotation = self._transform.transform.rotation

    def _on_pose(self, pose: Pose) -> None:
        stamp, translation, rotation = self._stamp, self._translation, self._rotation
        stamp.sec, stamp.nanosec = divmod(self._clock.now_ns(), S_TO_NS)
        translation.x = pose.x
        translation.y = pose.y
        half = pose.theta / 2.0
        rotation.z = sin(half)
        rotation.w = cos(half)
        self._broadcaster.sendTransform(self._transform)


def main() -> None:
    """Run the program until Ctrl-C or a shutdown."""
    spin(FramePublisher)


if __name__ == '__main__':
    main()
