"""What a link and its side process say to each other: frames of a kind, a number, another number, and bytes."""

from __future__ import annotations

import struct
from collections.abc import Iterator

_HEAD = struct.Struct('<IBIq')

# What the link says.
NODE, NODE_GONE, ADD, REMOVE, PUBLISH, ASK, ANSWER = range(7)
# What the side process says.
READY, MESSAGE, REQUEST, RESPONSE, GRAPH, TROUBLE = range(16, 22)


def frame(kind: int, handle: int = 0, number: int = 0, data: bytes = b'') -> bytes:
    """A frame."""
    return _HEAD.pack(len(data), kind, handle, number) + data


class Frames:
    """Cuts a stream of bytes into frames."""

    def __init__(self) -> None:
        self._bytes = bytearray()

    def feed(self, data: bytes) -> Iterator[tuple[int, int, int, bytes]]:
        """What is complete with some more bytes: (kind, handle, number, data)."""
        self._bytes += data
        at = 0
        while len(self._bytes) - at >= _HEAD.size:
            size, kind, handle, number = _HEAD.unpack_from(self._bytes, at)
            if len(self._bytes) - at < _HEAD.size + size:
                break
            yield kind, handle, number, bytes(self._bytes[at + _HEAD.size : at + _HEAD.size + size])
            at += _HEAD.size + size
        del self._bytes[:at]
