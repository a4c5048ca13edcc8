"""Reads untrusted files (only regular files, up to a maximum size), and writes each file either completely or not at all."""

from __future__ import annotations

import errno
import os
import stat
from collections.abc import Callable, Iterator
from contextlib import suppress

from edulaunch.errors import UnusableInput

from .faults import REPAIR, fault_of, raise_fault

BINARY = getattr(os, 'O_BINARY', 0)
"""A flag for `os.open`, without which Windows changes line ends."""


def read_regular(path: str, most: int) -> bytes:
    """Return the first `most` bytes of a file.

    :raises OSError: if the file is not regular or cannot be read. (Reading a pipe would block, and a device has no end.)
    """
    with open(os.open(path, os.O_RDONLY | BINARY | getattr(os, 'O_NONBLOCK', 0) | getattr(os, 'O_CLOEXEC', 0)), 'rb') as file:
        if not stat.S_ISREG(os.fstat(file.fileno()).st_mode):
            raise OSError(errno.EINVAL, 'it is not a regular file', path)
        return file.read(most)


def read_given(path: str, most: int, what: str = '', help: str | None = None) -> bytes:
    """Read a file like `read_regular`, for a path that the user has given.

    :param most: the maximum number of bytes.
    :param what: a description of the file with a space at its end: ``'the key '``.
    :param help: the help for the error message, or None.
    :raises UnusableInput: if the file cannot be read.
    :raises ComputerFault: if the computer is the reason.
    """
    try:
        return read_regular(path, most)
    except (OSError, ValueError) as error:  # ValueError: a zero byte in the path
        raise_fault(error)
        why = getattr(error, 'strerror', None) or error
        raise UnusableInput(f'{what}{path} cannot be read: {why}', help=help) from None


def files_below(folder: str, is_taken: Callable[[str, str], bool]) -> Iterator[str]:
    """Yield the paths of the files below a folder, relative to the folder and with slashes, in alphabetical order.

    The files of a folder come before the files of its subfolders.

    :param is_taken: a function that returns whether to yield a file, or to enter a directory. Its arguments are the name, and
        the path of the parent in `folder`. This path is '' or ends in a slash.
    """
    for place, folders, names in os.walk(folder):
        here = os.path.relpath(place, folder).replace(os.sep, '/')
        inside = '' if here == '.' else f'{here}/'
        folders[:] = sorted(name for name in folders if is_taken(name, inside))
        yield from (inside + name for name in sorted(names) if is_taken(name, inside))


def write_whole(path: str, text: str | bytes) -> None:
    """Write a file so that other programs never read an incomplete file.

    A lone surrogate (from a file name that is not UTF-8) is written as an escape sequence. A path that is not a regular file,
    such as ``/dev/stdout`` or a pipe, is written to and never replaced.

    :raises UnusableInput: if the file cannot be written.
    """
    data = text if isinstance(text, bytes) else text.encode('utf-8', 'backslashreplace')
    try:
        target = os.path.realpath(path)
        if path.startswith('/dev/') or (os.path.exists(target) and not os.path.isfile(target)):
            with open(path, 'wb') as file:
                file.write(data)
        else:
            _replace(target, data)
    except (OSError, ValueError) as error:  # ValueError: a zero byte in the path
        raise UnusableInput(
            f'the file {path} cannot be written: {getattr(error, "strerror", None) or error}',
            help=REPAIR if fault_of(error) else 'name a file in a folder that exists and that you may write to',
        ) from None


def _replace(path: str, data: bytes) -> None:
    """Replace a file with a complete one, or create the file."""
    temporary = f'{path}.{os.urandom(4).hex()}.part'
    try:
        with open(os.open(temporary, os.O_WRONLY | os.O_CREAT | os.O_EXCL | BINARY, 0o666), 'wb') as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        os.replace(temporary, path)
    except BaseException:
        with suppress(OSError):
            os.unlink(temporary)
        raise
