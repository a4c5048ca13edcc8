"""The program one_off_timer: a timer that fires once; makes a new timer each time."""

from __future__ import annotations

import sys

import rclpy
from rclcpp_like import run_program

from demo_nodes_cpp._two_timers import TwoTimers


def main() -> None:
    """Run the program; its exit code is that of the original."""
    sys.exit(run_program(lambda: rclpy.spin(TwoTimers('one_off_timer', reuse=False))))


if __name__ == '__main__':
    main()
