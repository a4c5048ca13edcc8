"""Writes files whole or not at all."""

from __future__ import annotations

import os
from contextlib import suppress

from edulaunch.errors import UnusableInput

from .regular_file import BINARY


def write_whole(path: str, text: str | bytes) -> None:
    """Write a file; a reader never finds half of it.

    Half a character (a lone surrogate, as in names of files that are not UTF-8) is written as its number. What is no regular
    file, such as ``/dev/stdout`` or a pipe, is written to and never replaced.

    :raises UnusableInput: when it cannot be written there.
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
            help='name a file in a folder that exists and that you may write to',
        ) from None


def _replace(path: str, data: bytes) -> None:
    """Put a complete file in the place of another one, or of none."""
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
