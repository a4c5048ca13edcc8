"""Counts the nodes of each name that a launch has started."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


_KEY = 'unique_ros_node_names'


def add_node_name(context: LaunchContext, node_name: str) -> int:
    """Count a node with this full name. Return the number of nodes with this name so far."""
    counts = context.local(_KEY)
    if counts is None:
        counts = {}
        context.extend_globals({_KEY: counts})
    count: int = counts.get(node_name, 0) + 1
    counts[node_name] = count
    return count


def get_node_name_count(context: LaunchContext, node_name: str) -> int:
    """Return the number of nodes with this name so far."""
    counts: dict[str, int] = context.local(_KEY) or {}
    return counts.get(node_name, 0)
