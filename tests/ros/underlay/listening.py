"""A program that listens to tf2, and what is sent to it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import rclpy
import tf2_ros
from geometry_msgs.msg import TransformStamped
from rclpy.node import Node


def stamped(parent: str, child: str, seconds: float, x: float) -> TransformStamped:
    ns = round(seconds * 1e9)
    return TransformStamped.from_wire((*divmod(ns, 10**9), parent, child, x, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0))


def listening(stage: Any, program: Any, use: Callable[[Node, tf2_ros.Buffer], None], **options: Any) -> None:
    """A program with a node, a buffer and a listener, set up by `use` and then spun."""

    def body() -> None:
        rclpy.init()
        node = Node('listener')
        buffer = tf2_ros.Buffer(**options)
        node.keep = tf2_ros.TransformListener(buffer, node)
        use(node, buffer)
        rclpy.spin(node)

    program(body)
