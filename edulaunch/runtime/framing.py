"""Frames between two processes of edulaunch. A frame has the length of the payload, a kind, and the payload. Nothing is
unpickled or evaluated.

Such frames pass between a terminal and its machine, and between the two peers of a link. edulaunch and the process with the
real rclpy exchange them, too. The grader's sandbox has a different kind of frames.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

HEADER_BYTES = 5
LONGEST_OF_ALL = (1 << 32) - 1


class BadFrame(Exception):
    """Bytes that are not a valid frame were received."""


_KINDS = [bytes((kind,)) for kind in range(256)]


def frame(kind: int, payload: bytes = b'') -> bytes:
    """Return a frame as bytes.

    :param kind: 0 to 255.
    :param payload: at most `LONGEST_OF_ALL` bytes.
    """
    return len(payload).to_bytes(4, 'little') + _KINDS[kind] + payload


class Frames:
    """Splits received bytes into frames.

    :param longest: the maximum size of a payload in bytes, or this maximum for each allowed kind.
    """

    def __init__(self, longest: int | Mapping[int, int] = LONGEST_OF_ALL) -> None:
        self._kinds = None if isinstance(longest, int) else longest
        self._longest = longest if isinstance(longest, int) else 0
        self._data = bytearray()
        self._at = 0

    def feed(self, data: bytes) -> Iterator[tuple[int, bytes]]:
        """Add received bytes. Return an iterator over the complete frames as (kind, payload).

        Frames that the caller does not consume remain for the next call.

        :raises BadFrame: for an unknown kind or a payload that is too long, after the frames before it.
        """
        self.add(data)
        return iter(self.take, None)

    def add(self, data: bytes) -> None:
        """Add received bytes without reading frames."""
        del self._data[: self._at]
        self._at = 0
        self._data += data

    def take(self) -> tuple[int, bytes] | None:
        """Return the next complete frame as (kind, payload), or None if no frame is complete.

        :raises BadFrame: for an unknown kind or a payload that is too long.
        """
        start = self._at + HEADER_BYTES
        if len(self._data) < start:
            return None
        kind, end = self._data[start - 1], start + int.from_bytes(self._data[self._at : start - 1], 'little')
        if end - start > (self._longest if self._kinds is None else self._kinds.get(kind, -1)):
            raise BadFrame(f'a frame of kind {kind} with {end - start} bytes')
        if len(self._data) < end:
            return None
        self._at = end
        return kind, bytes(self._data[start:end])
