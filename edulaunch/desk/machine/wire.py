"""The kinds of frames between a terminal and its machine, and the format of the first frame."""

from __future__ import annotations

from collections.abc import Sequence

HELLO = ord(b'H')
"""The terminal's first frame. Its fields are the token, the folder, the columns, the lines, and which of stdin, stdout and stderr
are terminals. Then come the number of words, the words, and the environment as NAME=VALUE. See :func:`pack`.
"""
INPUT = ord(b'I')
"""Typed bytes; empty at the end of the input."""
SIGNAL = ord(b'S')
SIZE = ord(b'Z')
WELCOME = ord(b'W')
"""The machine's first frame."""
ANSWER = ord(b'A')
"""The machine has handled all signals so far."""
OUTPUT = ord(b'1')
ERRORS = ord(b'2')
MODE = ord(b'M')
"""The mode of the keyboard: a sum of CANONICAL, ECHO and SIGNALS."""
READ = ord(b'R')
"""A program reads, so the terminal must send its keyboard input from now on."""
EXIT = ord(b'X')

CANONICAL, ECHO, SIGNALS = 1, 2, 4
PLAIN_MODE = CANONICAL | ECHO | SIGNALS
LONGEST_HELLO = 4 << 20
LONGEST = 1 << 20


def pack(fields: Sequence[str]) -> bytes:
    """Return a payload that contains the strings. No string may contain NUL."""
    return b'\0'.join(field.encode('utf-8', 'surrogateescape') for field in fields)


def unpack(payload: bytes) -> list[str]:
    """Return the strings that :func:`pack` has put into a payload."""
    return [field.decode('utf-8', 'surrogateescape') for field in payload.split(b'\0')]


FROM_TERMINAL = {HELLO: LONGEST_HELLO, INPUT: LONGEST, SIGNAL: 8, SIZE: 32}
FROM_MACHINE = {WELCOME: 0, ANSWER: 0, OUTPUT: LONGEST, ERRORS: LONGEST, MODE: 8, READ: 0, EXIT: 16}
