"""How the programs of this package run: spin one node until Ctrl-C or shutdown."""

from __future__ import annotations

from collections.abc import Callable

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


def spin(make_node: Callable[[], Node]) -> None:
    """Make the node and spin it; Ctrl-C ends the program well."""
    try:
        rclpy.init()
        rclpy.spin(make_node())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()
