"""How many nodes of one launch have the same name."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext

_KEY = 'unique_ros_node_names'


def add_node_name(context: LaunchContext, node_name: str) -> None:
    """Count a node with this full name."""
    counts = context.get_locals_as_dict().get(_KEY)
    if counts is None:
        counts = {}
        context.extend_globals({_KEY: counts})
    counts[node_name] = counts.get(node_name, 0) + 1


def get_node_name_count(context: LaunchContext, node_name: str) -> int:
    """How often the name was counted."""
    count: int = context.get_locals_as_dict().get(_KEY, {}).get(node_name, 0)
    return count
