"""How the demo programs run."""

from __future__ import annotations

from collections.abc import Callable

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


def spin(make_node: Callable[[], Node]) -> None:
    """Make a node and spin it until Ctrl-C or shutdown, which both end the program well."""
    run(lambda: rclpy.spin(make_node()))


def run(body: Callable[[], object]) -> None:
    """Run `body` between init and shutdown."""
    try:
        rclpy.init()
        body()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()
