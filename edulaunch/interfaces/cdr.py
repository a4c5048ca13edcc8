"""CDR bytes of messages, as ROS 2 middlewares and rosbag2 files carry them (XCDR1, little-endian)."""

from __future__ import annotations

import struct
from typing import Any, TypeVar

from edulaunch.errors import InterfaceError
from edulaunch.interfaces.cdr_steps import Codec, Truncated, make_codec
from edulaunch.interfaces.message import Message

HEADER = b'\x00\x01\x00\x00'
AnyMessage = TypeVar('AnyMessage', bound=Message)


def serialize(message: Message) -> bytes:
    """The CDR bytes of a message, with the 4-byte header.

    :raises AssertionError: when the message holds a value that its type does not allow.
    """
    return encode(type(message), type(message).to_wire(message))


def deserialize(data: bytes, cls: type[AnyMessage]) -> AnyMessage:
    """A new message of class `cls` from CDR bytes.

    :raises InterfaceError: when the bytes are no CDR of that type.
    """
    message: AnyMessage = cls.from_wire(decode(cls, data))
    return message


def encode(cls: type[Message], wire: tuple[Any, ...]) -> bytes:
    """The CDR bytes of a wire tuple of class `cls`."""
    body = bytearray()
    _codec(cls).write(body, wire)
    return HEADER + body


def decode(cls: type[Message], data: bytes) -> tuple[Any, ...]:
    """The wire tuple that CDR bytes of class `cls` hold.

    :raises InterfaceError: when the bytes are no CDR of that type.
    """
    if bytes(data[:2]) != HEADER[:2]:
        raise InterfaceError(
            f'these bytes are not little-endian CDR: they start with {bytes(data[:4]).hex(" ") or "nothing"}',
            help=f'a {cls.TYPE} starts with {HEADER.hex(" ")}',
        )
    body = bytes(data[4:])
    try:
        wire, _ = _codec(cls).read(body, 0)  # what follows does not matter: Fast DDS leaves room behind some messages
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
