"""The protocol between a link and its child process. A frame has a kind, a handle, a number, and bytes."""

from __future__ import annotations

import struct
from collections import deque
from collections.abc import Callable, Iterable, Iterator

from edulaunch.runtime import framing

_HEAD = struct.Struct('<Iq')
CHUNK = 1 << 18
"""The size, in bytes, up to which small frames are collected before they are sent."""

# Frames of the link.
NODE, NODE_GONE, ADD, REMOVE, PUBLISH, ASK, ANSWER = range(7)
# Frames of the side process.
READY, MESSAGE, REQUEST, RESPONSE, GRAPH, TROUBLE = range(16, 22)


def frame(kind: int, handle: int = 0, number: int = 0, data: bytes = b'') -> bytes:
    """Return a frame as bytes."""
    return framing.frame(kind, _HEAD.pack(handle, number) + data)


def opened(frames: Iterable[tuple[int, bytes]]) -> Iterator[tuple[int, int, int, bytes]]:
    """Yield each frame as (kind, handle, number, data)."""
    for kind, payload in frames:
        yield kind, *_HEAD.unpack_from(payload), payload[_HEAD.size :]


class Outbox:
    """Frames that wait to be sent. An urgent frame is sent before all other frames, but after a frame that is partly sent."""

    def __init__(self) -> None:
        self._half_sent = memoryview(b'')
        self._urgent: deque[bytes] = deque()
        self._usual: deque[bytes] = deque()
        self.size = 0

    def put(self, frame: bytes, *, is_urgent: bool = False) -> None:
        """Add a frame."""
        (self._urgent if is_urgent else self._usual).append(frame)
        self.size += len(frame)

    def send(self, write: Callable[[memoryview], int]) -> None:
        """Send all waiting frames.

        :param write: sends the beginning of some bytes and returns the number of bytes that it accepted.
        :raises BlockingIOError: from `write`, when it accepts no more bytes now. The remaining bytes still wait.
        """
        while self.size:
            if not self._half_sent:
                self._half_sent = memoryview(self._next_chunk())
            count = write(self._half_sent)
            self._half_sent = self._half_sent[count:]
            self.size -= count

    def clear(self) -> None:
        """Discard all waiting frames."""
        self._half_sent, self.size = memoryview(b''), 0
        self._urgent.clear()
        self._usual.clear()

    def _next_chunk(self) -> bytes:
        chunk: list[bytes] = []
        size = 0
        for frames in (self._urgent, self._usual):
            while frames and size < CHUNK:
                chunk.append(frames.popleft())
                size += len(chunk[-1])
        return chunk[0] if len(chunk) == 1 else b''.join(chunk)
