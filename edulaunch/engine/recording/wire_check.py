"""Whether the values of a recorded message are such as a message of its type could have."""

from __future__ import annotations

from collections.abc import Callable
from operator import eq, le
from typing import Any

from edulaunch.engine.interfaces.layout import is_byte_like
from edulaunch.engine.interfaces.registry import Registry
from edulaunch.engine.interfaces.spec import FieldType, MessageSpec
from edulaunch.errors import InterfaceError

Check = Callable[[Any], bool]
MOST_VALUES = 10_000
"""Of one message and of the messages in it, its repeated fields counted once."""
LENGTHS: dict[str, Callable[[int, int], bool]] = {'fixed': eq, 'bounded': le}


class WireChecks:
    """Looks at wires (see `interfaces.layout`) as they come out of a file, by the types of a registry."""

    def __init__(self, registry: Registry) -> None:
        self._registry = registry
        self._known: dict[str, list[Check]] = {}
        self._messages: dict[str, int] = {}
        self._open: list[str] = []

    def entries(self, type_name: str) -> list[Check]:
        """Return what looks at each value of a message, nested messages laid flat.

        :raises InterfaceError: when there is no such message type, it contains itself, or has more than MOST_VALUES values.
        """
        if type_name not in self._known:
            if type_name in self._open:
                raise InterfaceError(f'{type_name} contains itself', help='a message must have a finite size')
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
        """Return whether a value is the wire of a message of that type. Raises as :meth:`entries`."""
        checks = self.entries(type_name)

        def fits(value: Any) -> bool:
            if type(value) not in (list, tuple) or len(value) != len(checks):
                return False
            return all(check(item) for check, item in zip(checks, value, strict=True))

        return fits


def _value(field_type: FieldType) -> Check:
    kind = field_type.kind
    assert kind is not None
    if kind.python is bytes:
        return lambda value: type(value) is bytes and len(value) == 1
    if kind.python is int:
        low, high = kind.low, kind.high
        return lambda value: type(value) is int and low <= value <= high
    python = kind.python
    return lambda value: type(value) is python


def _repeated(field_type: FieldType, check: Check) -> Check:
    if not field_type.array:
        return check
    has_length, size = LENGTHS.get(field_type.array), field_type.size
    if is_byte_like(field_type):
        return lambda value: type(value) is bytes and (has_length is None or has_length(len(value), size))

    def fits(value: Any) -> bool:
        if type(value) not in (list, tuple) or (has_length is not None and not has_length(len(value), size)):
            return False
        return all(map(check, value))

    return fits
