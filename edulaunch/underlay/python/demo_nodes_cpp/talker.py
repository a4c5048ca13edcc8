"""The program talker: a numbered greeting on `chatter` every second."""

from __future__ import annotations

import sys
from typing import Any

import rclpy
from rclcpp_like import CppNode, run_program
from std_msgs.msg import String


class Talker(CppNode):
    """Counts from 1."""

    def __init__(self, **options: Any) -> None:
        super().__init__('talker', **options)
        self._number = 0
        self._chatter = self.create_publisher(String, 'chatter', 7)
        self._timer = self.create_wall_timer(1.0, self._on_timer)

    def _on_timer(self) -> None:
        self._number += 1
        message = String(data=f'Hello World: {self._number}')
        self.get_logger().info(f"Publishing: '{message.data}'")
        self._chatter.publish(message)


def main() -> None:
    """Run the program; its exit code is that of the original."""
    sys.exit(run_program(lambda: rclpy.spin(Talker())))


if __name__ == '__main__':
    main()
