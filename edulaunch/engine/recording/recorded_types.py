"""The classes of a student's own messages, created from their definitions in a recording. No code is compiled for them, because a
recording is only data.
"""

from __future__ import annotations

from array import array
from collections.abc import Callable, Iterator
from itertools import islice
from typing import Any

from edulaunch.engine.interfaces.field_rule import FieldRule
from edulaunch.engine.interfaces.generator import module_of
from edulaunch.engine.interfaces.layout import is_byte_like, is_fixed_numbers, is_number_sequence, layout_of
from edulaunch.engine.interfaces.message import Message
from edulaunch.engine.interfaces.registry import Registry
from edulaunch.engine.interfaces.spec import Field, InterfaceSpec, MessageSpec
from edulaunch.engine.interfaces.texts import TextRegistry
from edulaunch.engine.recording.wire_check import WireChecks

_kind: Any = type(Message)
Read = Callable[[Iterator[Any]], Any]


class RecordedTypes(TextRegistry):
    """The interfaces of a recording, and all importable interfaces. Messages of recorded types can be read, compared and
    shown.

    :ivar checks: checks whether wire tuples are valid for their types.
    """

    def __init__(self, texts: dict[str, str], base: Registry) -> None:
        super().__init__(texts, base)
        self.checks = WireChecks(self)

    def _make(self, spec: InterfaceSpec) -> type[Any]:
        return self._message(spec) if isinstance(spec, MessageSpec) else super()._make(spec)

    def _message(self, spec: MessageSpec) -> type[Message]:
        self.checks.entries(spec.type)  # raises an error for a type that contains itself
        readers = [(field.name, self._reader(field)) for field in spec.fields]

        def from_wire(wire: Any) -> Any:
            values, message = iter(wire), object.__new__(made)
            message.__dict__.update({name: read(values) for name, read in readers}, _wire=_frozen(wire))
            return message

        named = {'__module__': module_of(spec.type), 'TYPE': spec.type, '_SPEC': spec, 'from_wire': staticmethod(from_wire)}
        named['LAYOUT'] = layout_of(spec, self.spec)  # type: ignore[arg-type]  # the checks have refused all others
        named['_FIELDS'] = {field.name: field.type.ros_text for field in spec.fields}
        made = _kind(spec.type.rpartition('/')[2], (RecordedMessage,), named)
        for constant in spec.constants:
            setattr(made, constant.name, constant.value)
        return made  # type: ignore[no-any-return]

    def _reader(self, field: Field) -> Read:
        """Return a function that takes the values of a field from an iterator over a wire tuple, and returns the value of the
        field.
        """
        kind = field.type.kind
        if kind is None:
            one = self.get(field.type.base).from_wire
            if field.type.array:
                return lambda values: [one(item) for item in next(values)]
            width = len(self.checks.entries(field.type.base))
            return lambda values: one(tuple(islice(values, width)))
        if is_fixed_numbers(field.type):
            rule, stored = FieldRule(field, None), bytes if is_byte_like(field.type) else tuple
            return lambda values: rule.to_numpy(stored(next(values)))
        if is_number_sequence(field.type):
            return lambda values: array(kind.code, next(values))
        if is_byte_like(field.type):
            return lambda values: [bytes([item]) for item in next(values)]
        return (lambda values: list(next(values))) if field.type.array else next


def _frozen(value: Any) -> Any:
    """Convert the lists from a file back to tuples."""
    return tuple(map(_frozen, value)) if type(value) in (list, tuple) else value


class RecordedMessage(Message):
    """The base class of messages of a recorded type."""

    def to_wire(self) -> Any:
        """Return the wire from which the message was created."""
        return self.__dict__['_wire']

    def __eq__(self, other: object) -> bool:
        return type(other) is type(self) and other.__dict__['_wire'] == self.__dict__['_wire']

    __hash__ = None  # type: ignore[assignment]
