"""Run the built-in programs, each of which is a node that spins until Ctrl-C."""

from __future__ import annotations

from collections.abc import Callable

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


def spin(make_node: Callable[[], Node], args: list[str] | None = None) -> None:
    """Create a node and spin it until Ctrl-C or shutdown, after which the program ends without an error."""
    run(lambda: rclpy.spin(make_node()), args)


def run(body: Callable[[], object], args: list[str] | None = None) -> None:
    """Run `body` between init and shutdown. `args` are those of `rclpy.init` (default: those of the command line)."""
    try:
        rclpy.init(args=args)
        body()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()
