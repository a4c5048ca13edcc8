"""Read the progress files of a class, which are untrusted files from a shared drive, home folders or clones.

No code of a student runs, and links are not followed. A file that is too large, or does not come from `check()`, is rejected
with a fixed reason. Such a file does not affect other students.
"""

from __future__ import annotations

import os
import re
import stat
import sys
from collections.abc import Iterator
from math import isfinite
from typing import Any, NamedTuple

from edugrade.course import LEVELS
from edugrade.progress_file import ANSWERS, KINDS, NAME, PREDICTIONS

from edulaunch.errors import UnusableInput

MOST_BYTES = 64 << 10
MOST_TABLES, MOST_TRIES, MOST_POINTS, MOST_ANSWERS = 500, 100_000, 10_000, 100
MOST_STUDENTS = 2000
MOST_ENTRIES, DEEPEST = 20_000, 8  # limits for the folder of one student
LEFT_OUT = ('node_modules', '__pycache__', 'build', 'install', 'log', 'site-packages')
_MOODLE = re.compile(r'_\d+_assignsubmission_file_?$')


class Done(NamedTuple):
    """The record of one exercise for one student."""

    done: bool = False
    attempts: int = 0
    hints: int = 0
    best_points: float = 0.0

    def __or__(self, other: object) -> Done:
        """Return the better of two records of one exercise, which come from two files of one student."""
        if not isinstance(other, Done):
            return NotImplemented
        tries, hints = max(self.attempts, other.attempts), max(self.hints, other.hints)
        return Done(self.done or other.done, tries, hints, max(self.best_points, other.best_points))


class Standing(NamedTuple):
    """The content of the files of one student.

    :ivar answers: the chosen letters for each question, in order.
    """

    student: str
    exercises: dict[str, Done]
    answers: dict[str, list[str]]


class Refused(NamedTuple):
    """A progress file that was rejected: its path in the folder, and the reason."""

    path: str
    why: str


def read_class(folder: str) -> tuple[list[Standing], list[Refused]]:
    """Read every progress file below a folder. Each entry of the folder belongs to one student.

    :raises UnusableInput: when the folder cannot be listed, or has no progress file.
    """
    try:
        names = sorted(os.listdir(folder))
    except OSError as error:
        help = 'name a folder with one folder for each student'
        if os.path.isfile(folder):
            help += ', and unpack an archive before'
        raise UnusableInput(f'cannot read {folder}: {error.strerror}', help=help) from None
    found: dict[str, Standing] = {}
    refused = [Refused(os.curdir, f'only the first {MOST_STUDENTS} entries are read')] if len(names) > MOST_STUDENTS else []
    for name in names[:MOST_STUDENTS]:
        for path in _files(folder, name):
            try:
                if os.path.islink(os.path.join(folder, path)):
                    raise ValueError('it is a link, and links are not followed')
                exercises, answers = _read(os.path.join(folder, path))
            except (OSError, ValueError) as error:
                refused.append(Refused(path, getattr(error, 'strerror', None) or str(error)))
                continue
            student = _student(name)
            known = found.setdefault(student, Standing(student, {}, {}))
            for exercise, done in exercises.items():
                known.exercises[exercise] = known.exercises.get(exercise, Done()) | done
            known.answers.update(answers)
    if not found and not refused:
        raise UnusableInput(
            f'there is no {NAME} below {folder}', help='ask students to hand in this file, which is beside their notebooks'
        )
    return list(found.values()), refused


def _student(name: str) -> str:
    bare = name.removesuffix(NAME).rstrip('_- ') if name.endswith(NAME) else name
    return _MOODLE.sub('', bare) or os.curdir


def _files(folder: str, name: str) -> Iterator[str]:
    """Return the progress files in one entry of a folder, by their paths in the entry."""
    place = os.path.join(folder, name)
    if os.path.islink(place):
        return
    if not os.path.isdir(place):
        if name.endswith(NAME):
            yield name
        return
    count = 0
    for here, folders, files in os.walk(place):
        inside = os.path.relpath(here, folder)
        count += len(folders) + len(files)
        is_deep = inside.count(os.sep) >= DEEPEST
        folders[:] = [] if is_deep else sorted(each for each in folders if not each.startswith('.') and each not in LEFT_OUT)
        if NAME in files:
            yield os.path.join(inside, NAME)
        if count > MOST_ENTRIES:
            return


def _read(path: str) -> tuple[dict[str, Done], dict[str, list[str]]]:
    """Return the content of a progress file. For an invalid file, raise OSError or ValueError with a fixed message."""
    if sys.version_info >= (3, 11):
        import tomllib
    else:
        import tomli as tomllib
    flags = os.O_RDONLY | getattr(os, 'O_NOFOLLOW', 0) | getattr(os, 'O_NONBLOCK', 0) | getattr(os, 'O_CLOEXEC', 0)
    with open(os.open(path, flags), 'rb') as file:
        if not stat.S_ISREG(os.fstat(file.fileno()).st_mode):
            raise ValueError('it is not a regular file')
        data = file.read(MOST_BYTES + 1)
    if len(data) > MOST_BYTES:
        raise ValueError(f'it has more than {MOST_BYTES >> 10} KiB')
    try:
        tables = tomllib.loads(data.decode())
    except (ValueError, RecursionError):  # the messages of these errors may quote the file
        raise ValueError('it is not TOML') from None
    tables.pop(PREDICTIONS, None)
    answers = tables.pop(ANSWERS, {})
    if len(tables) > MOST_TABLES:
        raise ValueError(f'it has more than {MOST_TABLES} exercises')
    return {name: _done(table) for name, table in tables.items()}, _answers(answers)


def _done(table: Any) -> Done:
    if not isinstance(table, dict) or not table.keys() <= KINDS.keys():
        raise ValueError('it has a table that check() did not write')
    for name, value in table.items():
        if type(value) not in KINDS[name]:
            raise ValueError(f'{name} in it has the wrong type')
    tries, points, hints = table.get('attempts', 0), table.get('best_points', 0), table.get('hints', [])
    if not 0 <= tries <= MOST_TRIES or not (isfinite(points) and 0 <= points <= MOST_POINTS):
        raise ValueError('a number in it is too large or invalid')
    if len(hints) > LEVELS or any(type(level) is not int or not 1 <= level <= LEVELS for level in hints):
        raise ValueError('its hints are not valid hint levels')
    return Done(table.get('done', False), tries, len(set(hints)), float(points))


def _answers(given: Any) -> dict[str, list[str]]:
    if not isinstance(given, dict) or len(given) > MOST_TABLES:
        raise ValueError('its answers were not written by quiz()')
    for letters in given.values():
        if not isinstance(letters, list) or len(letters) > MOST_ANSWERS or any(type(each) is not str for each in letters):
            raise ValueError('its answers were not written by quiz()')
    return {name: [letter[:1] for letter in letters] for name, letters in given.items()}
