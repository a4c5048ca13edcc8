"""Frames between a terminal and its machine: a letter, a length and plain bytes. Nothing is unpickled or evaluated."""

from __future__ import annotations

from collections.abc import Sequence

HELLO = b'H'
"""From the terminal, first: token, folder, columns, lines, which of stdin, stdout and stderr are terminals, number of words, the
words, and the environment as NAME=VALUE; see :func:`pack`."""
INPUT = b'I'
"""Typed bytes; empty at the end of the input."""
SIGNAL = b'S'
SIZE = b'Z'
WELCOME = b'W'
"""From the machine, first."""
ANSWER = b'A'
"""The machine has handled all signals so far."""
OUTPUT = b'1'
ERRORS = b'2'
MODE = b'M'
"""The mode of the keyboard: a sum of CANONICAL, ECHO and SIGNALS."""
READ = b'R'
"""A program reads: pass on the keyboard from now on."""
EXIT = b'X'

CANONICAL, ECHO, SIGNALS = 1, 2, 4
PLAIN_MODE = CANONICAL | ECHO | SIGNALS
LONGEST_HELLO = 4 << 20
LONGEST = 1 << 20
_HEADER = 5


class BadFrame(Exception):
    """These bytes are not a valid frame."""


def frame(kind: bytes, payload: bytes = b'') -> bytes:
    """Return a frame as bytes."""
    return kind + len(payload).to_bytes(4, 'big') + payload


def pack(fields: Sequence[str]) -> bytes:
    """Return strings without NUL as one payload."""
    return b'\0'.join(field.encode('utf-8', 'surrogateescape') for field in fields)


def unpack(payload: bytes) -> list[str]:
    """Return the strings of :func:`pack`."""
    return [field.decode('utf-8', 'surrogateescape') for field in payload.split(b'\0')]


class Frames:
    """Splits received bytes into frames.

    :param kinds: the allowed letters, with the longest payload of each.
    """

    def __init__(self, kinds: dict[bytes, int]) -> None:
        self._kinds = kinds
        self._data = bytearray()

    def feed(self, data: bytes) -> list[tuple[bytes, bytes]]:
        """Return the complete frames, as (kind, payload).

        :raises BadFrame: for an unknown letter or a payload that is too long.
        """
        self._data += data
        found = []
        while len(self._data) >= _HEADER:
            kind, length = bytes(self._data[:1]), int.from_bytes(self._data[1:_HEADER], 'big')
            if length > self._kinds.get(kind, -1):
                raise BadFrame(f'{kind!r} of {length} bytes')
            if len(self._data) < _HEADER + length:
                break
            found.append((kind, bytes(self._data[_HEADER : _HEADER + length])))
            del self._data[: _HEADER + length]
        return found


FROM_TERMINAL = {HELLO: LONGEST_HELLO, INPUT: LONGEST, SIGNAL: 8, SIZE: 32}
FROM_MACHINE = {WELCOME: 0, ANSWER: 0, OUTPUT: LONGEST, ERRORS: LONGEST, MODE: 8, READ: 0, EXIT: 16}
