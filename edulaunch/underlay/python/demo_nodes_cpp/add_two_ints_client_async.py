"""The program add_two_ints_client_async: asks add_two_ints_server for 2 + 3."""

from __future__ import annotations

import sys

from rclcpp_like import run_program

from demo_nodes_cpp._asking import ask


def main() -> None:
    """Run the program; its exit code is that of the original."""
    sys.exit(run_program(ask))


if __name__ == '__main__':
    main()
