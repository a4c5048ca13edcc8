"""The old place of :func:`launch_ros.events.matchers.matches_node_name`."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from typing import Any

from ..matches_node_name import matches_node_name as _matches_node_name


def matches_node_name(node_name: str) -> Callable[[Any], bool]:
    """As in the new place, with a warning."""
    warnings.warn(
        'launch_ros.events.lifecycle.matches_node_name is deprecated, use launch_ros.events.matchers.matches_node_name instead',
        stacklevel=2,
    )
    return _matches_node_name(node_name)
