"""The program turtle_tf2_broadcaster, which broadcasts the pose of a turtle as the transform world -> turtle."""

from __future__ import annotations

from math import cos, sin

from rclpy.constants import S_TO_NS
from rclpy.node import Node
from tf2_ros import TransformBroadcaster
from turtlesim.msg import Pose

from edulaunch.ros.running import spin


class FramePublisher(Node):
    """Broadcasts one transform for each pose of the turtle in the parameter `turtlename`."""

    def __init__(self) -> None:
        super().__init__('turtle_tf2_frame_publisher')
        self._turtle = self.declare_parameter('turtlename', 'turtle').get_parameter_value().string_value
        self._clock = self.get_clock()
        self._transforms = TransformBroadcaster(self).pub_tf
        self._poses = self.create_subscription(Pose, f'/{self._turtle}/pose', self._on_pose, 1)
        self._poses.rcl_take_wires(self._on_pose)

    def _on_pose(self, pose: tuple[float, ...]) -> None:
        """Broadcast a pose. Pose and transform are wire tuples with fields in order, because each turtle needs 62.5 calls a
        second.
        """
        x, y, theta, _, _ = pose
        half = theta / 2.0
        stamp = divmod(self._clock.rcl_now_ns(), S_TO_NS)
        self._transforms.send_wire((((*stamp, 'world', self._turtle, x, y, 0.0, 0.0, 0.0, sin(half), cos(half)),),))


def main() -> None:
    """Run the program until Ctrl-C or a shutdown."""
    spin(FramePublisher)


if __name__ == '__main__':
    main()
