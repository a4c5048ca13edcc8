"""The content of a .msg, .srv or .action file as plain immutable data, the primitive types, and the names of modules."""

from __future__ import annotations

import re
from typing import Any, NamedTuple


class Primitive:
    """One primitive type.

    `code` is the type code in both `array` and `struct`. `python` is the Python type of the values. `low` and `high` are the
    inclusive limits of numbers. `ros` is the name in `get_fields_and_field_types()`, and `type_id` is the number in a type
    description.
    """

    # Plain classes here and in `layout`: each NamedTuple would add half a millisecond to every start.
    __slots__ = ('name', 'python', 'code', 'size', 'low', 'high', 'ros', 'type_id')

    def __init__(self, name: str, python: type, code: str, size: int, low: float, high: float, ros: str, type_id: int) -> None:
        self.name = name
        self.python = python
        self.code = code
        self.size = size
        self.low = low
        self.high = high
        self.ros = ros
        self.type_id = type_id

    @property
    def is_number(self) -> bool:
        """Whether the type is a number. Repeated numbers are stored in an `array.array` or a numpy array, and other values in
        lists.
        """
        return self.python is int or self.python is float

    @property
    def range_words(self) -> str:
        """Return the range in the words of ROS's assertions, or '' for a type without a range."""
        if self.python is float:
            return f'{self.ros} in [{self.low!r}, {self.high!r}]'
        if self.python is int:
            return f'{"unsigned " if self.name[0] == "u" else ""}integer in [{self.low}, {self.high}]'
        return ''


FLOAT32_MAX = 3.402823466e38
FLOAT64_MAX = 1.7976931348623157e308


def _integer(name: str, code: str, size: int, type_id: int) -> Primitive:
    bits = 8 * size
    low, high = (0, 2**bits - 1) if name[0] == 'u' else (-(2 ** (bits - 1)), 2 ** (bits - 1) - 1)
    return Primitive(name, int, code, size, low, high, name, type_id)


# `char` is missing, because `primitive_name` turns it into uint8, as ROS 2 does.
KINDS: dict[str, Primitive] = {
    kind.name: kind
    for kind in (
        Primitive('bool', bool, '?', 1, 0, 1, 'boolean', 15),
        Primitive('byte', bytes, 'c', 1, 0, 255, 'octet', 16),
        _integer('int8', 'b', 1, 2),
        _integer('uint8', 'B', 1, 3),
        _integer('int16', 'h', 2, 4),
        _integer('uint16', 'H', 2, 5),
        _integer('int32', 'i', 4, 6),
        _integer('uint32', 'I', 4, 7),
        _integer('int64', 'q', 8, 8),
        _integer('uint64', 'Q', 8, 9),
        Primitive('float32', float, 'f', 4, -FLOAT32_MAX, FLOAT32_MAX, 'float', 10),
        Primitive('float64', float, 'd', 8, -FLOAT64_MAX, FLOAT64_MAX, 'double', 11),
        Primitive('string', str, '', 0, 0, 0, 'string', 17),
        Primitive('wstring', str, '', 0, 0, 0, 'wstring', 18),
    )
}
PRIMITIVE_NAMES = (*KINDS, 'char')
BYTE_LIKE = frozenset({'byte', 'int8', 'uint8'})
"""Kinds whose repeated values are one bytes object in the wire tuple."""


def primitive_name(name: str) -> str:
    """Return the kind that belongs to the name of a primitive type. In ROS 2, `char` is uint8."""
    return 'uint8' if name == 'char' else name


class FieldType(NamedTuple):
    """The type of a field.

    `base` is a primitive kind or a full type name ('geometry_msgs/msg/Point'). `string_bound` is the N of `string<=N`, or None.
    `array` is '' (a single value), 'fixed', 'bounded' or 'unbounded'. `size` is the N of `T[N]` and of `T[<=N]`.
    """

    base: str
    string_bound: int | None = None
    array: str = ''
    size: int = 0

    @property
    def kind(self) -> Primitive | None:
        """The primitive kind, or None if the base is another interface."""
        return KINDS.get(self.base)

    @property
    def element(self) -> FieldType:
        """The type of one element of a repeated field."""
        return FieldType(self.base, self.string_bound)

    @property
    def text(self) -> str:
        """The type in .msg notation, such as 'string<=10[<=5]'."""
        bound = '' if self.string_bound is None else f'<={self.string_bound}'
        return self.base + bound + self._brackets

    @property
    def _brackets(self) -> str:
        return {'': '', 'fixed': f'[{self.size}]', 'bounded': f'[<={self.size}]', 'unbounded': '[]'}[self.array]

    @property
    def ros_text(self) -> str:
        """The type as `get_fields_and_field_types()` returns it, such as 'sequence<double>', 'double[36]' or
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
    """One field of a message.

    `default` is a Python value, a tuple for a repeated field, or None. `line` is the line of the field in its file.
    """

    name: str
    type: FieldType
    default: Any = None
    line: int = 0


class Constant(NamedTuple):
    """One constant of a message, such as `uint8 INFO=20`."""

    name: str
    base: str
    value: Any


class MessageSpec(NamedTuple):
    """The definition of a message, or of a part such as the request of a service.

    The definition contains the full type name, the fields, the constants and the path of the file.
    """

    type: str
    fields: tuple[Field, ...]
    constants: tuple[Constant, ...] = ()
    file: str = ''


class ServiceSpec(NamedTuple):
    """The definition of a service."""

    type: str
    request: MessageSpec
    response: MessageSpec


class ActionSpec(NamedTuple):
    """The definition of an action."""

    type: str
    goal: MessageSpec
    result: MessageSpec
    feedback: MessageSpec


InterfaceSpec = MessageSpec | ServiceSpec | ActionSpec


def module_name(type_name: str) -> str:
    """Return the name of the module that ROS generates for a type: 'TransformStamped' -> 'transform_stamped', 'Pose2D' ->
    'pose2_d'.
    """
    spaced = re.sub('(.)([A-Z][a-z]+)', r'\1_\2', type_name)
    return re.sub('([a-z0-9])([A-Z])', r'\1_\2', spaced).lower()
