"""The program turtle_teleop_key: drives a turtle with the keys that arrive on standard input."""

from __future__ import annotations

import sys
import termios
import threading
import tty
from typing import Any

import rclpy
from geometry_msgs.msg import Twist
from rclcpp_like import CppNode, run_program
from rclpy.action import ActionClient

from turtlesim.action import RotateAbsolute

KEY_PERIOD_S = 0.5  # given text, which nobody types, is read at this rate, so that a command has time to act
ESCAPE = '\x1b'
# linear and angular of the arrows up, down, right, left
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
    """One Twist per arrow key; letters set, and cancel, rotation goals. Without input it stays idle.

    :param keyboard: a terminal, each key of which counts when it is pressed; or a text.
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
        """Follow the keys until somebody says stop. A terminal is read key by key meanwhile."""
        if self._timer is not None:
            rclpy.spin(self)
            return
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


def main() -> None:
    """Run the program; its exit code is that of the original."""
    sys.exit(run_program(lambda: TeleopTurtle(sys.stdin).spin()))


if __name__ == '__main__':
    main()
