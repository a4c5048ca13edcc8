"""The program mimic: repeats one turtle's motion as commands for another."""

from __future__ import annotations

import sys

import rclpy
from geometry_msgs.msg import Twist
from rclcpp_like import CppNode, run_program

from turtlesim.msg import Pose


class MimicNode(CppNode):
    """Sends every pose's velocities from `input/pose` on to `output/cmd_vel`, zeros included."""

    def __init__(self) -> None:
        super().__init__('turtle_mimic')
        self._twist = Twist()
        self._commands = self.create_publisher(Twist, 'output/cmd_vel', 7)
        self._poses = self.create_subscription(Pose, 'input/pose', self._on_pose, 7)

    def _on_pose(self, pose: Pose) -> None:
        twist = self._twist
        twist.linear._x = pose._linear_velocity
        twist.angular._z = pose._angular_velocity
        self._commands.publish(twist)


def main() -> None:
    """Run the program; its exit code is that of the original."""
    sys.exit(run_program(lambda: rclpy.spin(MimicNode())))


if __name__ == '__main__':
    main()
