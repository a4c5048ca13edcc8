"""Writes files whole or not at all."""

from __future__ import annotations

import os

from edulaunch.errors import UnusableInput


def write_whole(path: str, text: str) -> None:
    """Write a text file; a reader never finds half of it.

    :raises UnusableInput: when it cannot be written there.
    """
    temporary = f'{path}.{os.getpid()}.part'
    try:
        with open(temporary, 'w', encoding='utf-8') as file:
            file.write(text)
            file.flush()
            os.fsync(file.fileno())
        os.replace(temporary, path)
    except OSError as error:
        raise UnusableInput(
            f'the file {path} cannot be written: {error.strerror or error}',
            help='name a file in a folder that exists and that you may write to',
        ) from None
