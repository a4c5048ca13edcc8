"""Attributes of a node that rclpy itself needs. A program that assigns a different object to one of them fails or causes a
warning.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from linecache import getlines
from typing import TYPE_CHECKING, Any

from edulaunch.engine.facts import with_facts

if TYPE_CHECKING:
    from rclpy.impl.protocols import NodeProtocol

AT_START = ('handle', 'default_callback_group', 'executor')
"""Attributes that a node needs when it is created."""
FOR_TIMERS = ('context',)
TO_SPIN = ('subscriptions', 'timers', 'clients', 'services', 'guards', 'waitables')
"""Attributes that an executor reads from each node."""


def check_own_names(node: NodeProtocol, names: tuple[str, ...]) -> None:
    """Use each of the given attributes of a node as rclpy does, so that a wrong object raises the same error.

    :raises TypeError, AttributeError: Python's own error, when an attribute contains an object of the wrong kind.
    """
    for name in names:
        held = getattr(node, name)
        try:
            _USES.get(name, iter)(held)
        except (TypeError, AttributeError) as error:
            raise with_facts(error, 'programs.own-name', node=type(node).__name__, attribute=name) from None


def private_names(node: NodeProtocol) -> Iterator[tuple[str, dict[str, Any]]]:
    """Yield a fact for each attribute of a program that replaces a private attribute of rclpy. The real rclpy fails when it next
    uses the attribute.
    """
    own = vars(node)
    for name in sorted(_PRIVATE_USES.keys() & own.keys()):
        if not hasattr(own[name], _PRIVATE_USES[name]):
            data = {'node': node.get_fully_qualified_name(), 'attribute': name}
            yield 'private name', {**data, **_line_of(node, name)}


def _line_of(node: NodeProtocol, name: str) -> dict[str, Any]:
    """Return the file of the node's class, and the line that first assigns the attribute. Return {} if the class has no
    constructor.
    """
    code = getattr(type(node).__init__, '__code__', None)
    if code is None or type(node).__init__.__module__.partition('.')[0] == 'rclpy':
        return {}
    lines = enumerate(getlines(code.co_filename), 1)
    return {'file': code.co_filename, 'line': next((number for number, text in lines if f'self.{name}' in text), None)}


def _enter(held: Any) -> None:
    if not hasattr(type(held), '__enter__'):  # with the message of Python 3.11 and later, in every version
        raise TypeError(f"'{type(held).__name__}' object does not support the context manager protocol")


_PRIVATE_USES = {
    **dict.fromkeys(('_publishers', '_subscriptions', '_clients', '_services', '_timers'), 'append'),
    **dict.fromkeys(('_parameters', '_descriptors'), 'keys'),
    **dict.fromkeys(('_clock', '_context'), 'handle'),
    '_default_callback_group': 'add_entity',
    '_logger': 'debug',
}
"""Private attributes of a node in the real rclpy, with the attribute that rclpy uses of each value."""
_USES: dict[str, Callable[[Any], object]] = {
    'handle': _enter,
    'default_callback_group': lambda group: group.add_entity,
    'executor': lambda executor: executor and executor.wake,
    'context': lambda context: context.handle,
}
