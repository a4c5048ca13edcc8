"""Access to a node's own state, for programs of edulaunch that run on edulaunch's rclpy or on the rclpy of ROS 2.

`core_of(node)` returns the names of a node, the parameter values from outside, and the node's place in the graph. edulaunch's
rclpy provides this state. Other code can replace the function: `edulaunch.extras.native` does so where ROS 2's own rclpy runs
edulaunch's programs. The replacement must have the members of `rclpy.node_parts.core.NodeCore` that the callers of `core_of` use.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

CoreOf = Callable[[Any], Any]


def _in_our_rclpy(node: Any) -> Any:
    from rclpy.node_parts.core import core_of  # imported here, because ROS 2's own rclpy has no such module

    return core_of(node)


_chosen: CoreOf = _in_our_rclpy


def choose(core_of_node: CoreOf) -> None:
    """Replace the function that :func:`core_of` calls, for the whole interpreter."""
    global _chosen
    _chosen = core_of_node


def core_of(node: Any) -> Any:
    """Return the state of a node: a `NodeCore`, or the object that replaces it on ROS 2's own rclpy."""
    return _chosen(node)
