"""The program draw_square: drives turtle1 round a square, for ever."""

from __future__ import annotations

import sys
from math import cos, floor, pi, sin
from typing import Any

import rclpy
from geometry_msgs.msg import Twist
from rclcpp_like import CppNode, run_program
from rclpy.task import Future
from std_srvs.srv import Empty

from turtlesim.msg import Pose

SIDE = 2.0
FORWARD, STOP_FORWARD, TURN, STOP_TURN = range(4)
COMMANDS = {FORWARD: (1.0, 0.0), TURN: (0.0, 0.4)}


class DrawSquare(CppNode):
    """Drive, stop, turn, stop: one state after the other, looked at every 16 ms."""

    def __init__(self) -> None:
        super().__init__('draw_square')
        self._pose: Pose | None = None
        self._goal: tuple[float, float, float] | None = None
        self._state = FORWARD
        self._commands = self.create_publisher(Twist, 'turtle1/cmd_vel', 7)
        self._poses = self.create_subscription(Pose, 'turtle1/pose', self._on_pose, 7)
        self._reset = self.create_client(Empty, 'reset')
        self._reset_reply: Future | None = None
        self._ask_for_a_reset()
        self._timer = self.create_wall_timer(0.016, self._on_timer)

    def _ask_for_a_reset(self) -> bool:
        """Ask once there is somebody to ask: as with a real middleware, a request made before turtlesim is there is not lost.

        Returns whether the reset is over.
        """
        if self._reset_reply is None:
            if not self._reset.service_is_ready():
                return False
            self._reset_reply = self._reset.call_async(Empty.Request())
        return bool(self._reset_reply.done())

    def _on_pose(self, pose: Pose) -> None:
        self._pose = pose

    def _on_timer(self) -> None:
        pose = self._pose
        if not self._ask_for_a_reset() or pose is None:
            return
        if self._goal is None:
            self._set_goal(_ahead(pose))
        if self._state in COMMANDS:
            self._drive(pose)
        elif pose.angular_velocity < 0.0001 and pose.linear_velocity < 0.0001:
            self.get_logger().info('Reached goal')
            self._set_goal(self._turned() if self._state == STOP_FORWARD else _ahead(pose))
            self._state = (self._state + 1) % 4
        else:
            self._command(0.0, 0.0)

    def _drive(self, pose: Any) -> None:
        if self._reached(pose):
            self._command(0.0, 0.0)
            self._state += 1
        else:
            self._command(*COMMANDS[self._state])

    def _reached(self, pose: Any) -> bool:
        assert self._goal is not None
        x, y, theta = self._goal
        near = abs(pose.x - x) < 0.1 and abs(pose.y - y) < 0.1
        return near and bool(abs(pose.theta - theta) < 0.01)

    def _turned(self) -> tuple[float, float, float]:
        assert self._goal is not None
        x, y, theta = self._goal
        theta += pi / 2.0
        return x, y, theta - 2.0 * pi * floor((theta + pi) / (2.0 * pi))

    def _set_goal(self, goal: tuple[float, float, float]) -> None:
        self._goal = goal
        self.get_logger().info('New goal [{:f} {:f}, {:f}]'.format(*goal))

    def _command(self, linear: float, angular: float) -> None:
        twist = Twist()
        twist.linear.x = linear
        twist.angular.z = angular
        self._commands.publish(twist)


def _ahead(pose: Any) -> tuple[float, float, float]:
    return pose.x + cos(pose.theta) * SIDE, pose.y + sin(pose.theta) * SIDE, pose.theta


def main() -> None:
    """Run the program; its exit code is that of the original."""
    sys.exit(run_program(lambda: rclpy.spin(DrawSquare())))


if __name__ == '__main__':
    main()
