"""What a .msg, .srv or .action text says, as plain immutable data."""

from __future__ import annotations

from typing import Any, NamedTuple

from edulaunch.interfaces.kinds import KINDS, Kind


class FieldType(NamedTuple):
    """The type of a field.

    `base` is a primitive kind or a full type name ('geometry_msgs/msg/Point'); `string_bound` the N of
    `string<=N` or None; `array` one of '' (a single value), 'fixed', 'bounded', 'unbounded'; `size` the N of
    `T[N]` and `T[<=N]`.
    """

    base: str
    string_bound: int | None = None
    array: str = ''
    size: int = 0

    @property
    def kind(self) -> Kind | None:
        """The primitive kind, or None when the base is another interface."""
        return KINDS.get(self.base)

    @property
    def element(self) -> FieldType:
        """The type of one value of a repeated field."""
        return FieldType(self.base, self.string_bound)

    @property
    def text(self) -> str:
        """The type in .msg notation: 'string<=10[<=5]'."""
        bound = '' if self.string_bound is None else f'<={self.string_bound}'
        return self.base + bound + self._brackets

    @property
    def _brackets(self) -> str:
        return {'': '', 'fixed': f'[{self.size}]', 'bounded': f'[<={self.size}]', 'unbounded': '[]'}[self.array]

    @property
    def ros_text(self) -> str:
        """The type as `get_fields_and_field_types()` shows it: 'sequence<double>', 'double[36]',
        'geometry_msgs/Point'.
        """
        kind = self.kind
        if kind is None:
            package, _, name = self.base.split('/')
            one = f'{package}/{name}'
        else:
            one = kind.ros + ('' if self.string_bound is None else f'<{self.string_bound}>')
        return {
            '': one,
            'fixed': f'{one}[{self.size}]',
            'bounded': f'sequence<{one}, {self.size}>',
            'unbounded': f'sequence<{one}>',
        }[self.array]


class Field(NamedTuple):
    """One field; `default` is a Python value (a tuple for repeated fields) or None; `line` its line in the
    file.
    """

    name: str
    type: FieldType
    default: Any = None
    line: int = 0


class Constant(NamedTuple):
    """One constant: `uint8 INFO=20`."""

    name: str
    base: str
    value: Any


class MessageSpec(NamedTuple):
    """One message, or one half of a service: its full type name, fields, constants and the file it was read
    from.
    """

    type: str
    fields: tuple[Field, ...]
    constants: tuple[Constant, ...] = ()
    file: str = ''


class ServiceSpec(NamedTuple):
    """One service."""

    type: str
    request: MessageSpec
    response: MessageSpec


class ActionSpec(NamedTuple):
    """One action."""

    type: str
    goal: MessageSpec
    result: MessageSpec
    feedback: MessageSpec


InterfaceSpec = MessageSpec | ServiceSpec | ActionSpec
