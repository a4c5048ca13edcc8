"""Runs the built-in programs, each of which is a node that spins until Ctrl-C."""

from __future__ import annotations

from collections.abc import Callable

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


def spin(make_node: Callable[[], Node], args: list[str] | None = None) -> None:
    """Create a node, and spin it until Ctrl-C or shutdown. The program then ends without an error."""
    run(lambda: rclpy.spin(make_node()), args)


def run(body: Callable[[], object], args: list[str] | None = None) -> None:
    """Call `body` between init and shutdown.

    :param args: the arguments of `rclpy.init`. By default, they are those of the command line.
    """
    try:
        rclpy.init(args=args)
        body()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()
