"""The program teleop_twist_keyboard: it publishes a velocity command on cmd_vel for each key."""

from __future__ import annotations

import sys
import termios
import threading
import tty
from contextlib import suppress
from typing import Any

import rclpy
from geometry_msgs.msg import Twist, TwistStamped
from rclpy.executors import ExternalShutdownException

HELP = """
This program turns the keys of a terminal into Twist or TwistStamped messages.
It is made for a US keyboard.
---------------------------
Moving around:
   u    i    o
   j    k    l
   m    ,    .

For Holonomic mode (strafing), hold down the shift key:
---------------------------
   U    I    O
   J    K    L
   M    <    >

t : up (+z)
b : down (-z)

anything else : stop

q/z : increase/decrease max speeds by 10%
w/x : increase/decrease only linear speed by 10%
e/c : increase/decrease only angular speed by 10%

CTRL-C to quit
"""
MOVES = {
    'i': (1, 0, 0, 0),
    'o': (1, 0, 0, -1),
    'j': (0, 0, 0, 1),
    'l': (0, 0, 0, -1),
    'u': (1, 0, 0, 1),
    ',': (-1, 0, 0, 0),
    '.': (-1, 0, 0, 1),
    'm': (-1, 0, 0, -1),
    'O': (1, -1, 0, 0),
    'I': (1, 0, 0, 0),
    'J': (0, 1, 0, 0),
    'L': (0, -1, 0, 0),
    'U': (1, 1, 0, 0),
    '<': (-1, 0, 0, 0),
    '>': (-1, -1, 0, 0),
    'M': (-1, 1, 0, 0),
    't': (0, 0, 1, 0),
    'b': (0, 0, -1, 0),
}
"""Directions of linear x, y, z and of the turn."""
SPEEDS = {'q': (1.1, 1.1), 'z': (0.9, 0.9), 'w': (1.1, 1.0), 'x': (0.9, 1.0), 'e': (1.0, 1.1), 'c': (1.0, 0.9)}
"""Factors of the linear and of the angular speed."""
CTRL_C = '\x03'
LINES_BEFORE_HELP = 15


class Teleop:
    """The speeds (m/s and rad/s) and the direction that the keys have set.

    If the parameter `stamped` (default: false) is true, the node publishes TwistStamped. The parameter `frame_id` (default: '')
    is the frame of its header.
    """

    def __init__(self) -> None:
        self._node = rclpy.create_node('teleop_twist_keyboard')
        self._stamped = self._node.declare_parameter('stamped', False).value
        self._frame = self._node.declare_parameter('frame_id', '').value
        if not self._stamped and self._frame:
            raise ValueError("'frame_id' can only be set when 'stamped' is True")
        self._commands = self._node.create_publisher(TwistStamped if self._stamped else Twist, 'cmd_vel', 10)
        self._speed, self._turn, self._lines = 0.5, 1.0, 0
        self._direction: tuple[float, ...] = (0, 0, 0, 0)

    def run(self) -> None:
        """Handle keys until Ctrl-C, and then stop the robot."""
        spinning = threading.Thread(target=self._spin)
        spinning.start()
        before = termios.tcgetattr(sys.stdin)
        try:
            print(HELP)
            self._tell_speeds()
            while (key := _key(before)) not in (CTRL_C, ''):
                self._follow(key)
        except KeyboardInterrupt:
            pass
        finally:
            termios.tcsetattr(sys.stdin, termios.TCSADRAIN, before)
            self._direction = (0, 0, 0, 0)
            self._publish()
            rclpy.try_shutdown()
            spinning.join()

    def _spin(self) -> None:
        with suppress(ExternalShutdownException):
            rclpy.spin(self._node)

    def _follow(self, key: str) -> None:
        if key in SPEEDS:
            linear, angular = SPEEDS[key]
            self._speed *= linear
            self._turn *= angular
            self._tell_speeds()
            self._lines = (self._lines + 1) % LINES_BEFORE_HELP
            if self._lines == 0:
                print(HELP)
        else:
            self._direction = MOVES.get(key, (0, 0, 0, 0))
        self._publish()

    def _tell_speeds(self) -> None:
        print(f'currently:\tspeed {self._speed}\tturn {self._turn} ')

    def _publish(self) -> None:
        message: Any = self._commands.msg_type()
        if self._stamped:
            message.header.stamp = self._node.get_clock().now().to_msg()
            message.header.frame_id = self._frame
        twist = message.twist if self._stamped else message
        x, y, z, turn = self._direction
        twist.linear.x, twist.linear.y, twist.linear.z = x * self._speed, y * self._speed, z * self._speed
        twist.angular.z = turn * self._turn
        self._commands.publish(message)


def _key(before: Any) -> str:
    """Wait for a key, and return it."""
    tty.setraw(sys.stdin.fileno())
    key = sys.stdin.read(1)
    termios.tcsetattr(sys.stdin, termios.TCSADRAIN, before)
    return key


def main(args: list[str] | None = None) -> None:
    """Run the program."""
    rclpy.init(args=args)
    Teleop().run()


if __name__ == '__main__':
    main()
