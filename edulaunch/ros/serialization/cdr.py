"""Converts messages to CDR bytes and back, as ROS 2 middlewares and rosbag2 files store them (XCDR1, little-endian). Positions
and alignments count from the end of the header.
"""

from __future__ import annotations

import struct
import sys
from array import array
from collections.abc import Iterator
from functools import cached_property
from struct import Struct
from typing import Any, Protocol, TypeVar

from edulaunch.engine.interfaces.layout import is_byte_like
from edulaunch.engine.interfaces.message import Message
from edulaunch.engine.interfaces.spec import FieldType, Primitive
from edulaunch.errors import InterfaceError

_COUNT = Struct('<I')


class Truncated(Exception):
    """The bytes end too early, or a count is larger than the number of remaining bytes."""


class Step(Protocol):
    """One part of the layout. It converts `takes` entries of the wire tuple."""

    takes: int

    def write(self, out: bytearray, values: tuple[Any, ...]) -> None: ...

    def read(self, data: bytes, position: int, values: list[Any]) -> int: ...


class Codec:
    """Writes and reads all fields of one message type in order."""

    def __init__(self, steps: list[Step]) -> None:
        self._steps: list[tuple[Step, slice]] = []
        start = 0
        for step in steps:
            self._steps.append((step, slice(start, start + step.takes)))
            start += step.takes

    def write(self, out: bytearray, wire: tuple[Any, ...]) -> None:
        """Append the bytes of a wire tuple."""
        for step, part in self._steps:
            step.write(out, wire[part])

    def read(self, data: bytes, position: int) -> tuple[tuple[Any, ...], int]:
        """Return the wire tuple that starts at a position, and the position after it."""
        values: list[Any] = []
        for step, _ in self._steps:
            position = step.read(data, position, values)
        return tuple(values), position


class Run:
    """A sequence of single numbers, booleans and bytes, with one struct for each of the 8 possible alignments of its start."""

    def __init__(self, kinds: list[Primitive | None]) -> None:
        self._kinds = kinds  # None stands for the byte of a message without fields
        self.takes = sum(kind is not None for kind in kinds)

    @cached_property
    def _structs(self) -> list[Struct]:
        return [self._struct(start) for start in range(8)]

    def _struct(self, start: int) -> Struct:
        codes, position = '<', start
        for kind in self._kinds:
            size = 1 if kind is None else kind.size
            codes += 'x' * (-position % size) + ('x' if kind is None else kind.code)
            position += -position % size + size
        return Struct(codes)

    def write(self, out: bytearray, values: tuple[Any, ...]) -> None:
        out += self._structs[len(out) & 7].pack(*values)

    def read(self, data: bytes, position: int, values: list[Any]) -> int:
        layout = self._structs[position & 7]
        values += layout.unpack_from(data, position)
        return position + layout.size


class Text:
    """A string: the number of bytes including the final zero, the UTF-8 bytes, and a zero."""

    takes = 1

    def write(self, out: bytearray, values: tuple[Any, ...]) -> None:
        encoded = values[0].encode()
        _write_count(out, len(encoded) + 1)
        out += encoded + b'\x00'

    def read(self, data: bytes, position: int, values: list[Any]) -> int:
        length, position = _read_count(data, position, 1)
        if length == 0 or data[position + length - 1]:
            raise Truncated(f'a string at byte {position} does not end with a zero')
        values.append(data[position : position + length - 1].decode())
        return position + length


class WideText:
    """A wide string: the number of UTF-16 units, and then each unit as 32 bits, without a final zero (as rmw_fastrtps does)."""

    takes = 1

    def write(self, out: bytearray, values: tuple[Any, ...]) -> None:
        units = array('H', values[0].encode('utf-16-' + ('le' if sys.byteorder == 'little' else 'be')))
        _write_count(out, len(units))
        out += Struct(f'<{len(units)}I').pack(*units)

    def read(self, data: bytes, position: int, values: list[Any]) -> int:
        count, position = _read_count(data, position, 4)
        units = Struct(f'<{count}I').unpack_from(data, position)
        values.append(Struct(f'<{count}H').pack(*(unit & 0xFFFF for unit in units)).decode('utf-16-le'))
        return position + 4 * count


class Numbers:
    """An array of numbers, booleans or bytes. `size` is the length of a fixed array, and None for a sequence."""

    takes = 1

    def __init__(self, field_type: FieldType) -> None:
        kind = field_type.kind
        assert kind is not None
        self._code, self._width = kind.code, kind.size
        self._raw = is_byte_like(field_type)
        self._size = field_type.size if field_type.array == 'fixed' else None

    def write(self, out: bytearray, values: tuple[Any, ...]) -> None:
        several = values[0]
        if self._size is None:
            _write_count(out, len(several))
        if several:
            out += b'\x00' * (-len(out) % self._width)
            out += several if self._raw else Struct(f'<{len(several)}{self._code}').pack(*several)

    def read(self, data: bytes, position: int, values: list[Any]) -> int:
        count = self._size
        if count is None:
            count, position = _read_count(data, position, self._width)
        if not count:
            values.append(b'' if self._raw else ())
            return position
        position += -position % self._width
        end = position + count * self._width
        if end > len(data):
            raise Truncated(f'{count} values at byte {position} reach beyond the end')
        values.append(data[position:end] if self._raw else Struct(f'<{count}{self._code}').unpack_from(data, position))
        return end


class Several:
    """An array of strings or messages."""

    takes = 1

    def __init__(self, one: Step | Codec, size: int | None) -> None:
        self._one = one
        self._size = size

    def write(self, out: bytearray, values: tuple[Any, ...]) -> None:
        if self._size is None:
            _write_count(out, len(values[0]))
        for value in values[0]:
            self._one.write(out, value if isinstance(self._one, Codec) else (value,))

    def read(self, data: bytes, position: int, values: list[Any]) -> int:
        count = self._size
        if count is None:
            count, position = _read_count(data, position, 1)
        several: list[Any] = []
        for _ in range(count):
            if isinstance(self._one, Codec):
                wire, position = self._one.read(data, position)
                several.append(wire)
            else:
                position = self._one.read(data, position, several)
        values.append(tuple(several))
        return position


def make_codec(cls: type[Message]) -> Codec:
    """Return the codec of a message class."""
    steps: list[Step] = []
    run: list[Primitive | None] = []
    for part in _parts(cls):
        if part is None or isinstance(part, Primitive):
            run.append(part)
            continue
        if run:
            steps.append(Run(run))
            run = []
        steps.append(part)
    return Codec([*steps, Run(run)] if run else steps)


def _parts(cls: type[Message]) -> Iterator[Primitive | None | Step]:
    if not cls._FIELDS:
        yield None
    for rule in cls._RULES.values():
        field_type, nested = rule.type, rule.message
        if nested is not None and not field_type.array:
            yield from _parts(nested)
        else:
            yield _part(field_type, nested)


def _part(field_type: FieldType, nested: type[Message] | None) -> Primitive | Step:
    size = field_type.size if field_type.array == 'fixed' else None
    kind = field_type.kind
    if kind is None:
        assert nested is not None
        return Several(make_codec(nested), size)
    if kind.python is str:
        text = Text() if kind.name == 'string' else WideText()
        return Several(text, size) if field_type.array else text
    return Numbers(field_type) if field_type.array else kind


def _write_count(out: bytearray, count: int) -> None:
    out += b'\x00' * (-len(out) % 4)
    out += _COUNT.pack(count)


def _read_count(data: bytes, position: int, width: int) -> tuple[int, int]:
    """Return a count. Raise an error unless enough bytes remain for that many elements of `width` bytes."""
    position += -position % 4
    (count,) = _COUNT.unpack_from(data, position)
    if count * width > len(data) - position - 4:
        raise Truncated(f'a count of {count} at byte {position} reaches beyond the end')
    return count, position + 4


HEADER = b'\x00\x01\x00\x00'
AnyMessage = TypeVar('AnyMessage', bound=Message)


def serialize(message: Message) -> bytes:
    """Return the CDR bytes of a message, with the 4-byte header.

    :raises AssertionError: when the message contains a value that its type does not allow.
    """
    return encode(type(message), type(message).to_wire(message))


def deserialize(data: bytes, cls: type[AnyMessage]) -> AnyMessage:
    """Return a new message of class `cls` from CDR bytes.

    :raises InterfaceError: when the bytes are not the CDR of that type.
    """
    message: AnyMessage = cls.from_wire(decode(cls, data))
    return message


def encode(cls: type[Message], wire: tuple[Any, ...]) -> bytes:
    """Return the CDR bytes of a wire tuple of class `cls`."""
    body = bytearray()
    _codec(cls).write(body, wire)
    return HEADER + body


def decode(cls: type[Message], data: bytes) -> tuple[Any, ...]:
    """Return the wire tuple of class `cls` from its CDR bytes.

    :raises InterfaceError: when the bytes are not the CDR of that type.
    """
    if bytes(data[:2]) != HEADER[:2]:
        raise InterfaceError(
            f'these bytes are not little-endian CDR: they start with {bytes(data[:4]).hex(" ") or "nothing"}',
            help=f'pass the bytes of a {cls.TYPE}, which start with {HEADER.hex(" ")}',
        )
    body = bytes(data[4:])
    try:
        wire, _ = _codec(cls).read(body, 0)  # ignore the rest, because Fast DDS adds padding after some messages
    except (struct.error, Truncated, UnicodeDecodeError, OverflowError) as error:
        raise InterfaceError(f'these {len(data)} bytes are not a {cls.TYPE}: {error}') from None
    return wire


def _codec(cls: type[Message]) -> Codec:
    codec = cls.__dict__.get('_CODEC')
    if codec is None:
        codec = make_codec(cls)
        cls._CODEC = codec
    assert isinstance(codec, Codec)
    return codec
