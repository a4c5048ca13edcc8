"""A matcher of nodes."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any


def matches_node_name(node_name: str) -> Callable[[Any], bool]:
    """Return a matcher for Node actions with this full name. The leading slash is optional."""
    absolute = node_name if node_name.startswith('/') else f'/{node_name}'
    return lambda action: bool(action.node_name == absolute)
