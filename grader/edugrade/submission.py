"""The file to grade, read as bytes: nothing here runs it."""

from __future__ import annotations

import os
from random import Random

from edulaunch.errors import UnusableInput

from .source import Source

ENDINGS = tuple(mark + kind for mark in ('.launch', '_launch') for kind in ('.py', '.xml', '.yaml', '.yml'))
LARGEST_BYTES = 1_000_000


class Submission:
    """A launch file that somebody handed in.

    :param path: as it was given.
    :raises UnusableInput: when there is no such launch file; the message says what was found instead.
    """

    def __init__(self, path: str) -> None:
        self.given = path
        self.file = os.path.abspath(path)
        self.folder, self.name = os.path.split(self.file)
        self.data = _read(path)
        self.exercise = exercise_of(self.name)
        self.source = Source(self.file, self.data.decode('utf-8', 'replace'))

    @property
    def seed(self) -> int:
        """A number that changes with every edit (a hash of the text); the rubric's choices come from it."""
        return Random(self.data).getrandbits(32)

    @property
    def sha256(self) -> str:
        """Names the graded text in the report."""
        from hashlib import sha256

        return sha256(self.data).hexdigest()


def exercise_of(name: str) -> str:
    """The exercise of a file name: ``circle`` for ``circle.launch.py`` and ``circle_launch.xml``."""
    for ending in ENDINGS:
        if name.endswith(ending):
            return name[: -len(ending)]
    return os.path.splitext(name)[0]


def _read(path: str) -> bytes:
    if os.path.isdir(path):
        raise UnusableInput(f'{path} is a directory; edugrade grades one launch file', help=_files_in(path))
    try:
        with open(path, 'rb') as file:
            data = file.read(LARGEST_BYTES + 1)
    except FileNotFoundError:
        raise UnusableInput(f'{path} does not exist', help=_nearest_to(path)) from None
    except OSError as error:
        raise UnusableInput(f'{path} cannot be read: {error.strerror or error}') from None
    if len(data) > LARGEST_BYTES:
        raise UnusableInput(
            f'{path} is larger than {LARGEST_BYTES:,} bytes; that is no launch file',
            help='give the path of the launch file',
        )
    return data


def _launch_files(folder: str) -> list[str]:
    try:
        return sorted(name for name in os.listdir(folder or '.') if name.endswith(ENDINGS))
    except OSError:
        return []


def _files_in(folder: str) -> str:
    names = _launch_files(folder)
    if not names:
        return f'there is no launch file in it (a name that ends in {ENDINGS[0]}); give the path of one'
    return 'try one of: ' + ', '.join(os.path.join(folder, name) for name in names)


def _nearest_to(path: str) -> str:
    from edulaunch.packages.nearest import nearest

    folder, name = os.path.split(path)
    if folder and not os.path.isdir(folder):
        return f'the folder {folder} does not exist either; look where you are with pwd and ls'
    names = _launch_files(folder)
    close = nearest(name, names)
    if close is not None:
        return f'did you mean {os.path.join(folder, close)}?'
    return f'launch files there: {", ".join(names)}' if names else 'there are no launch files in that folder'
