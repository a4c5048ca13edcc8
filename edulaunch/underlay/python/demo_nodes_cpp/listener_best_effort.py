"""The program listener_best_effort: as listener, content with messages that may get lost."""

from __future__ import annotations

import sys

import rclpy
from rclcpp_like import run_program
from rclpy.qos import qos_profile_sensor_data

from demo_nodes_cpp._hearing import Listener


def main() -> None:
    """Run the program; its exit code is that of the original."""
    sys.exit(run_program(lambda: rclpy.spin(Listener('listener', qos_profile_sensor_data))))


if __name__ == '__main__':
    main()
