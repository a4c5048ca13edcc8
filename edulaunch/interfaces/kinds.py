"""The primitive field types of ROS interfaces."""

from __future__ import annotations


class Kind:
    """One primitive type.

    `code` is the type code of both `array` and `struct`; `python` the type that a field of it holds; `low`
    and `high` the inclusive range of numbers; `ros` the name in `get_fields_and_field_types()`; `type_id` its
    number in a type description.
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
        """Numbers live in array.array or numpy arrays when repeated; everything else in lists."""
        return self.python is int or self.python is float

    @property
    def range_words(self) -> str:
        """The range as ROS words it in its assertions; empty when there is none."""
        if self.python is float:
            return f'{self.ros} in [{self.low!r}, {self.high!r}]'
        if self.python is int:
            return f'{"unsigned " if self.name[0] == "u" else ""}integer in [{self.low}, {self.high}]'
        return ''


FLOAT32_MAX = 3.402823466e38
FLOAT64_MAX = 1.7976931348623157e308


def _integer(name: str, code: str, size: int, type_id: int) -> Kind:
    bits = 8 * size
    low, high = (0, 2**bits - 1) if name[0] == 'u' else (-(2 ** (bits - 1)), 2 ** (bits - 1) - 1)
    return Kind(name, int, code, size, low, high, name, type_id)


# No `char`: ROS 2 turns it into uint8 before anything else sees it, and so does `primitive_name`.
KINDS: dict[str, Kind] = {
    kind.name: kind
    for kind in (
        Kind('bool', bool, '?', 1, 0, 1, 'boolean', 15),
        Kind('byte', bytes, 'c', 1, 0, 255, 'octet', 16),
        _integer('int8', 'b', 1, 2),
        _integer('uint8', 'B', 1, 3),
        _integer('int16', 'h', 2, 4),
        _integer('uint16', 'H', 2, 5),
        _integer('int32', 'i', 4, 6),
        _integer('uint32', 'I', 4, 7),
        _integer('int64', 'q', 8, 8),
        _integer('uint64', 'Q', 8, 9),
        Kind('float32', float, 'f', 4, -FLOAT32_MAX, FLOAT32_MAX, 'float', 10),
        Kind('float64', float, 'd', 8, -FLOAT64_MAX, FLOAT64_MAX, 'double', 11),
        Kind('string', str, '', 0, 0, 0, 'string', 17),
        Kind('wstring', str, '', 0, 0, 0, 'wstring', 18),
    )
}
PRIMITIVE_NAMES = (*KINDS, 'char')
BYTE_LIKE = frozenset({'byte', 'int8', 'uint8'})
"""Kinds whose repeated values travel as one bytes object."""


def primitive_name(name: str) -> str:
    """The kind that stands for a primitive type name: `char` is uint8 in ROS 2."""
    return 'uint8' if name == 'char' else name
