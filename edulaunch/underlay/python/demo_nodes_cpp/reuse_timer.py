"""The program reuse_timer: a timer that fires once; resets one timer again and again."""

from __future__ import annotations

import sys

import rclpy
from rclcpp_like import run_program

from demo_nodes_cpp._two_timers import TwoTimers


def main() -> None:
    """Run the program; its exit code is that of the original."""
    sys.exit(run_program(lambda: rclpy.spin(TwoTimers('reuse_timer', reuse=True))))


if __name__ == '__main__':
    main()
