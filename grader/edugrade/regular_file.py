"""Reads files of a stranger: nothing but regular ones, and no more of them than asked for."""

from __future__ import annotations

import errno
import os
import stat

BINARY = getattr(os, 'O_BINARY', 0)
"""For `os.open`: Windows would change the ends of lines."""


def read_regular(path: str, most: int) -> bytes:
    """The first `most` bytes of a file.

    :raises OSError: when it cannot be read, or is something else: a pipe makes its reader wait for ever, a device never ends.
    """
    with open(os.open(path, os.O_RDONLY | BINARY | getattr(os, 'O_NONBLOCK', 0) | getattr(os, 'O_CLOEXEC', 0)), 'rb') as file:
        if not stat.S_ISREG(os.fstat(file.fileno()).st_mode):
            raise OSError(errno.EINVAL, 'it is not a regular file', path)
        return file.read(most)
