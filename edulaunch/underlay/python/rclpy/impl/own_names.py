"""Names of `Node` that rclpy needs itself: a program that gives one of them another meaning is stopped where rclpy stumbles."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from edulaunch.facts import with_facts

if TYPE_CHECKING:
    from rclpy.node import Node

AT_START = ('handle', 'default_callback_group', 'executor')
"""What a node needs when it is made."""
FOR_TIMERS = ('context',)
TO_SPIN = ('subscriptions', 'timers', 'clients', 'services', 'guards', 'waitables')
"""What an executor asks each node for."""


def check_own_names(node: Node, names: tuple[str, ...]) -> None:
    """Use what a node has under these names as rclpy does.

    :raises TypeError, AttributeError: of something else under that name, in Python's words.
    """
    for name in names:
        held = getattr(node, name)
        try:
            _USES.get(name, iter)(held)
        except (TypeError, AttributeError) as error:
            raise with_facts(error, 'programs.own-name', node=type(node).__name__, attribute=name) from None


def _enter(held: Any) -> None:
    if not hasattr(type(held), '__enter__'):  # in the words of Python 3.11 and later, whichever runs
        raise TypeError(f"'{type(held).__name__}' object does not support the context manager protocol")


_USES: dict[str, Callable[[Any], object]] = {
    'handle': _enter,
    'default_callback_group': lambda group: group.add_entity,
    'executor': lambda executor: executor and executor.wake,
    'context': lambda context: context.handle,
}
