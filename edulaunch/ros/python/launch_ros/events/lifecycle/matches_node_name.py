"""The deprecated location of the matcher of node names."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from typing import Any

from .. import matchers


def matches_node_name(node_name: str) -> Callable[[Any], bool]:
    """Call :func:`launch_ros.events.matchers.matches_node_name`, after a warning that this name is deprecated."""
    warnings.warn(
        'launch_ros.events.lifecycle.matches_node_name is deprecated, use launch_ros.events.matchers.matches_node_name instead',
        stacklevel=2,
    )
    return matchers.matches_node_name(node_name)
