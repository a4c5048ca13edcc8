"""What people call the callback of an entity, and its node."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Any

from rclpy.node_parts.core import core_of

if TYPE_CHECKING:
    from rclpy.readiness import Entity


def callback_name(entity: Any) -> str | None:
    """The name of an entity's callback; None when it has none."""
    callback: Any = getattr(entity, 'callback', None)
    while isinstance(callback, partial):
        callback = callback.func
    name: str | None = getattr(callback, '__name__', None)
    return name


def node_name(entity: Entity) -> str | None:
    """The full name of the node whose entity it is; None when nobody spins that."""
    executor = entity.ready_list.executor
    nodes = [] if executor is None else executor.get_nodes()
    return next((core_of(node).full_name for node in nodes if core_of(node).ready_list is entity.ready_list), None)
