"""Checks whether the values of a recorded message are possible for its type."""

from __future__ import annotations

from collections.abc import Callable, Collection
from operator import eq, le
from typing import Any

from edulaunch.engine.interfaces.layout import is_byte_like
from edulaunch.engine.interfaces.registry import Registry
from edulaunch.engine.interfaces.spec import FieldType, MessageSpec
from edulaunch.engine.underlay_place import help_text
from edulaunch.errors import InterfaceError

Check = Callable[[Collection[Any]], bool]
"""Returns whether all of these values are valid. One call for many values takes a tenth of the time of many calls."""
MOST_VALUES = 10_000
"""The most values of one message with its nested messages; a repeated field counts as one value."""
LENGTHS: dict[str, Callable[[int, int], bool]] = {'fixed': eq, 'bounded': le}
SEQUENCES: set[Any] = {list, tuple}


class WireChecks:
    """Checks of wires (see `interfaces.layout`) from a file against the types of a registry."""

    def __init__(self, registry: Registry) -> None:
        self._registry = registry
        self._known: dict[str, list[Check]] = {}
        self._messages: dict[str, int] = {}
        self._open: list[str] = []

    def entries(self, type_name: str) -> list[Check]:
        """Return one check for each entry of the wire tuple of a type. A check gets the values of this entry in several messages.

        :raises InterfaceError: if the message type does not exist or contains itself, or if it has more than MOST_VALUES
            values.
        """
        if type_name not in self._known:
            if type_name in self._open:
                raise InterfaceError(f'{type_name} contains itself', help=help_text('endless'))
            self._open.append(type_name)
            try:
                self._known[type_name] = self._entries(type_name)
            finally:
                self._open.pop()
        return self._known[type_name]

    def _entries(self, type_name: str) -> list[Check]:
        spec = self._registry.spec(type_name)
        if not isinstance(spec, MessageSpec):
            raise InterfaceError(f'{type_name} is not a message type')
        found: list[Check] = []
        messages = 1
        for field in spec.fields:
            if field.type.kind is not None:
                found.append(_repeated(field.type, _value(field.type)))
            elif field.type.array:
                found.append(_repeated(field.type, self.check(field.type.base)))
            else:
                found += self.entries(field.type.base)
                messages += self._messages[field.type.base]
            if len(found) + messages > MOST_VALUES:
                raise InterfaceError(f'{type_name} has more than {MOST_VALUES} values')
        self._messages[type_name] = messages
        return found

    def check(self, type_name: str) -> Check:
        """Return a function that returns whether all given values are wires of messages of a type.

        :raises InterfaceError: as in :meth:`entries`.
        """
        checks = self.entries(type_name)

        def fit(values: Collection[Any]) -> bool:
            if not _are(SEQUENCES, values) or not set(map(len, values)) <= {len(checks)}:
                return False
            return not values or all(check(column) for check, column in zip(checks, zip(*values, strict=True), strict=True))

        return fit


def _are(types: set[Any], values: Collection[Any]) -> bool:
    return set(map(type, values)) <= types


def _value(field_type: FieldType) -> Check:
    kind = field_type.kind
    assert kind is not None
    types = {kind.python}
    if kind.python is bytes:
        return lambda values: _are(types, values) and set(map(len, values)) <= {1}
    if kind.python is int:
        low, high = kind.low, kind.high
        return lambda values: _are(types, values) and (not values or (low <= min(values) and max(values) <= high))
    return lambda values: _are(types, values)


def _repeated(field_type: FieldType, check: Check) -> Check:
    if not field_type.array:
        return check
    has_length, size = LENGTHS.get(field_type.array), field_type.size
    kinds: set[Any] = {bytes} if is_byte_like(field_type) else SEQUENCES

    def fit(values: Collection[Any]) -> bool:
        if not _are(kinds, values) or (has_length is not None and not all(has_length(len(value), size) for value in values)):
            return False
        return kinds is not SEQUENCES or all(map(check, values))

    return fit
