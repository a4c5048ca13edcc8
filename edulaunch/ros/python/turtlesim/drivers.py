"""The programs that drive turtles: draw_square, mimic and turtle_teleop_key."""

from __future__ import annotations

import sys
import threading
from math import cos, floor, pi, sin
from typing import Any

import rclpy
from geometry_msgs.msg import Twist
from rclcpp_like import CppNode, program, spinning
from rclpy.action import ActionClient
from rclpy.task import Future
from std_srvs.srv import Empty

from turtlesim.action import RotateAbsolute
from turtlesim.msg import Pose

SIDE = 2.0
FORWARD, STOP_FORWARD, TURN, STOP_TURN = range(4)
COMMANDS = {FORWARD: (1.0, 0.0), TURN: (0.0, 0.4)}


class DrawSquare(CppNode):
    """Drives a square in four states: drive, stop, turn, stop. It checks the state every 16 ms."""

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
        """Request a reset when the service exists. As with a real middleware, a request before the start of turtlesim is not
        lost.

        Return whether the reset is complete.
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


class MimicNode(CppNode):
    """Publishes the velocities of every pose on `input/pose` as commands on `output/cmd_vel`, including zero velocities."""

    def __init__(self) -> None:
        super().__init__('turtle_mimic')
        self._twist = Twist()
        self._commands = self.create_publisher(Twist, 'output/cmd_vel', 7)
        self._poses = self.create_subscription(Pose, 'input/pose', self._on_pose, 7)

    def _on_pose(self, pose: Pose) -> None:
        twist = self._twist
        twist.linear.x = pose.linear_velocity
        twist.angular.z = pose.angular_velocity
        self._commands.publish(twist)


KEY_PERIOD_S = 0.5  # period for reading prepared input, so that each command has time to act
ESCAPE = '\x1b'
# Linear and angular velocity for the arrows up, down, right and left.
ARROWS = {'A': (1.0, 0.0), 'B': (-1.0, 0.0), 'C': (0.0, -1.0), 'D': (0.0, 1.0)}
HEADINGS = {'g': 0.0, 't': 0.7854, 'r': 1.5708, 'e': 2.3562, 'd': 3.1416, 'c': -2.3562, 'v': -1.5708, 'b': -0.7854}
WELCOME = (
    'Reading from keyboard',
    '-' * 27,
    'Use arrow keys to move the turtle.',
    "Use G|B|V|C|D|E|R|T keys to rotate to absolute orientations. 'F' to cancel a rotation.",
    "'Q' to quit.",
)


class TeleopTurtle(CppNode):
    """Publishes one Twist for each arrow key. Letter keys send and cancel rotation goals.

    :param keyboard: a terminal that passes on each key when it is pressed, or a string of keys.
    """

    def __init__(self, keyboard: Any) -> None:
        super().__init__('teleop_turtle')
        self._keyboard = keyboard
        self._goal: Any = None
        self.declare_parameter('scale_angular', 2.0)
        self.declare_parameter('scale_linear', 2.0)
        self._commands = self.create_publisher(Twist, 'turtle1/cmd_vel', 7)
        self._rotations = ActionClient(self, RotateAbsolute, 'turtle1/rotate_absolute')
        self._timer = None if keyboard.isatty() else self.create_timer(KEY_PERIOD_S, self._read_key)
        print(*WELCOME, sep='\n')

    def spin(self) -> None:
        """Handle keys until the program is stopped. Until then, the terminal passes on each key as soon as the user
        presses it.
        """
        if self._timer is not None:
            rclpy.spin(self)
            return
        import termios  # imported here, because there may be no terminal
        import tty

        before = termios.tcgetattr(self._keyboard)
        tty.setcbreak(self._keyboard)
        threading.Thread(target=self._read_keys, daemon=True).start()
        try:
            rclpy.spin(self)
        finally:
            termios.tcsetattr(self._keyboard, termios.TCSADRAIN, before)

    def _read_keys(self) -> None:
        while rclpy.ok():
            self._read_key()

    def _read_key(self) -> None:
        key = self._keyboard.read(1)
        if key == ESCAPE and self._keyboard.read(1) == '[':
            self._move(self._keyboard.read(1))
        elif key in HEADINGS:
            goal = RotateAbsolute.Goal(theta=HEADINGS[key])
            self._rotations.send_goal_async(goal).add_done_callback(self._on_goal_reply)
        elif key == 'f' and self._goal is not None:
            self._goal.cancel_goal_async()
        elif key == 'q':
            rclpy.shutdown()
        elif not key and self._timer is not None:
            self._timer.cancel()

    def _move(self, arrow: str) -> None:
        if arrow in ARROWS:
            linear, angular = ARROWS[arrow]
            twist = Twist()
            twist.linear.x = linear * self.get_parameter('scale_linear').value
            twist.angular.z = angular * self.get_parameter('scale_angular').value
            self._commands.publish(twist)

    def _on_goal_reply(self, reply: Any) -> None:
        if reply.result().accepted:
            self._goal = reply.result()


draw_square = spinning(DrawSquare)
mimic = spinning(MimicNode)
turtle_teleop_key = program(lambda: TeleopTurtle(sys.stdin).spin())
