"""The program listener: logs what it hears on `chatter`."""

from __future__ import annotations

import sys

import rclpy
from rclcpp_like import run_program

from demo_nodes_cpp._hearing import Listener


def main() -> None:
    """Run the program; its exit code is that of the original."""
    sys.exit(run_program(lambda: rclpy.spin(Listener('listener', 10))))


if __name__ == '__main__':
    main()
