"""Which function transforms or converts which type.

Packages that come with edulaunch (`tf2_geometry_msgs`) are imported once for all processes and provide theirs
for all; what a program adds itself belongs to its process alone.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from edulaunch.processes.current import current_process

Key = Any
_provided: dict[str, dict[Key, Callable[..., Any]]] = {'transform': {}, 'to_msg': {}, 'from_msg': {}, 'convert': {}}


class TypeException(Exception):
    """Raised when an object of a type that nothing was registered for is to be transformed or converted."""

    __module__ = 'tf2_ros.buffer_interface'  # where ROS 2 has it: tracebacks show the module


def provide(table: str, key: Key, function: Callable[..., Any]) -> None:
    """Register for all processes; for packages of the underlay only."""
    _provided[table][key] = function


def _own(table: str) -> dict[Key, Callable[..., Any]]:
    tables = current_process().state.setdefault('tf2_ros.registrations', {})
    found: dict[Key, Callable[..., Any]] = tables.setdefault(table, {})
    return found


def _find(table: str, key: Key) -> Callable[..., Any]:
    function = _own(table).get(key) or _provided[table].get(key)
    if function is None:
        raise TypeException(f'Type {key} is not loaded or supported')
    return function


class TransformRegistration:
    """The functions that transform stamped objects, by the exact type of the object."""

    def print_me(self) -> None:
        """Print the registered types and the names of their functions."""
        shown = {**_provided['transform'], **_own('transform')}
        text = str({key: function.__name__ for key, function in shown.items()})
        current_process().write('stdout', f'{text}\n')

    def add(self, key: Key, callback: Callable[..., Any]) -> None:
        """Use `callback(object, TransformStamped)` for objects of type `key`."""
        _own('transform')[key] = callback

    def get(self, key: Key) -> Callable[..., Any]:
        """The function for a type.

        :raises TypeException: there is none.
        """
        return _find('transform', key)


class ConvertRegistration:
    """The functions that convert between types, directly or over a message type."""

    def add_from_msg(self, key: Key, callback: Callable[..., Any]) -> None:
        """`callback(message)` makes an object of type `key`."""
        _own('from_msg')[key] = callback

    def add_to_msg(self, key: Key, callback: Callable[..., Any]) -> None:
        """`callback(object)` makes a message of an object of type `key`."""
        _own('to_msg')[key] = callback

    def add_convert(self, key: Key, callback: Callable[..., Any]) -> None:
        """`callback(object)` converts directly; `key` is (type of the object, type of the result)."""
        _own('convert')[key] = callback

    def get_from_msg(self, key: Key) -> Callable[..., Any]:
        """Raises TypeException when there is none, as the other getters do."""
        return _find('from_msg', key)

    def get_to_msg(self, key: Key) -> Callable[..., Any]:
        """See :meth:`add_to_msg`."""
        return _find('to_msg', key)

    def get_convert(self, key: Key) -> Callable[..., Any]:
        """See :meth:`add_convert`."""
        return _find('convert', key)
