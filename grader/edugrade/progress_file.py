"""The progress of a student: a small readable file beside the notebook, which belongs to the student."""

from __future__ import annotations

import json
import os
import re
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from typing import Any

from edulaunch.errors import UnusableInput

from .course import read_toml
from .files import write_whole

NAME = 'my_progress.toml'
HEADER = '# My progress, kept by check(). It is mine: I may read it, copy it, and delete it to start over.\n'
PLACE = 'EDULAUNCH_PROGRESS'
"""The environment variable that names another folder for the file."""
PREDICTIONS, ANSWERS, EXPLANATIONS = 'my_predictions', 'my_answers', 'my_explanations'
"""The other tables in addition to those of the exercises: prediction -> value, question -> the answers in their order,
explanation -> text.
"""
KINDS: dict[str, tuple[type, ...]] = {
    'done': (bool,),
    'attempts': (int,),
    'hints': (list,),
    'best_points': (int, float),
    'points': (int,),
    'first': (str,),
    'last': (str,),
}
"""The types of the values in the record of an exercise."""
_BARE = re.compile(r'[A-Za-z0-9_-]+')


@dataclass
class Progress:
    """The progress in one exercise. `first` and `last` are the digests of the first and the last graded version."""

    done: bool = False
    attempts: int = 0
    hints: list[int] = field(default_factory=list)
    best_points: float = 0
    points: int = 0
    first: str = ''
    last: str = ''

    def attempt(self, earned: float, possible: int, passed: bool, text: str = '') -> bool:
        """Record a graded attempt, and keep the best result. Return True if the attempt repeats the last version, so that it
        does not count.

        :param earned: the earned points.
        :param possible: all points of the exercise.
        :param passed: whether all checks passed.
        :param text: the digest of the graded version.
        """
        if text and text == self.last:
            return True
        self.attempts += 1
        self.first, self.last = self.first or text, text
        self.done = self.done or passed
        self.best_points = max(self.best_points, earned)
        self.points = possible
        return False

    def open_hint(self, level: int) -> None:
        """Record that the student has read a hint."""
        if level not in self.hints:
            self.hints = sorted([*self.hints, level])


def place_of(folder: str) -> str:
    """Return the directory of the progress file for work in `folder`. The environment variable PLACE takes precedence.

    Set the variable to another directory for tests of a notebook, which are not attempts.
    """
    return os.environ.get(PLACE) or folder


class ProgressFile:
    """The progress file, with the progress of all exercises.

    :param folder: the directory of the file, which may not exist yet.
    :ivar word: a message for the student about the file, or ''.
    :ivar predictions: the student's predictions by their names.
    :ivar answers: the letters chosen for each question, in the order in which they were given.
    :ivar explanations: the student's explanations by their names.
    """

    def __init__(self, folder: str) -> None:
        self.path = os.path.join(place_of(folder), NAME)
        self.word = ''
        self._unreadable = ''
        self.exercises: dict[str, Progress] = {}
        self.predictions: dict[str, str] = {}
        self.answers: dict[str, list[str]] = {}
        self.explanations: dict[str, str] = {}
        self._read()

    def of(self, exercise: str) -> Progress:
        """Return the progress of one exercise. Callers may change it, and then save the file."""
        return self.exercises.setdefault(exercise, Progress())

    @classmethod
    @contextmanager
    def changing(cls, folder: str) -> Iterator[ProgressFile]:
        """Return a context manager that locks and provides the progress file, so that simultaneous attempts in two notebooks
        both count.
        """
        with _locked(place_of(folder)):
            yield cls(folder)

    def save(self) -> None:
        """Write the file completely. After a crash, the file has either the old content or the new content.

        :raises UnusableInput: if the file cannot be written, or if the existing file could not be read. An unreadable file
            is not overwritten.
        """
        if self._unreadable:
            raise UnusableInput(f'{NAME} cannot be read: {self._unreadable}')
        exercises = ''.join(_table(name, item) for name, item in self.exercises.items())
        tables: dict[str, dict[str, Any]] = {
            PREDICTIONS: self.predictions,
            ANSWERS: self.answers,
            EXPLANATIONS: self.explanations,
        }
        write_whole(self.path, HEADER + exercises + ''.join(_lines(name, table) for name, table in tables.items()))

    def _read(self) -> None:
        try:
            tables = read_toml(self.path)
            predictions, explanations = _texts(tables.pop(PREDICTIONS, {})), _texts(tables.pop(EXPLANATIONS, {}))
            answers = {name: list(_texts(dict(enumerate(given))).values()) for name, given in tables.pop(ANSWERS, {}).items()}
            self.exercises = {name: _progress(table) for name, table in tables.items()}
            self.predictions, self.answers, self.explanations = predictions, answers, explanations
        except FileNotFoundError:
            pass
        except OSError as error:
            self._unreadable = error.strerror or str(error)
        except (ValueError, TypeError, AttributeError) as error:
            self._put_aside(error)

    def _put_aside(self, error: Exception) -> None:
        """Rename a file with invalid content, so that it is not overwritten."""
        kept = f'{self.path}.bak'
        number = 1
        while os.path.exists(kept):
            number += 1
            kept = f'{self.path}.bak{number}'
        os.replace(self.path, kept)
        self.word = (
            f'{NAME} could not be understood ({error}). It is kept as {os.path.basename(kept)}, and a new one '
            'is begun; to have the old one back, mend it and rename it.'
        )


@contextmanager
def _locked(folder: str) -> Iterator[None]:
    """Hold a lock on the folder itself, so that no extra file is needed. Continue without a lock on disks that do not support
    locks.
    """
    descriptor = None
    try:
        with suppress(ImportError, OSError):
            import fcntl

            descriptor = os.open(folder, os.O_RDONLY)
            fcntl.flock(descriptor, fcntl.LOCK_EX)
        yield
    finally:
        if descriptor is not None:
            os.close(descriptor)


def _progress(table: Any) -> Progress:
    """Convert the table of an exercise, and raise an error if it is invalid."""
    found = Progress(**table)
    for name, known in KINDS.items():
        if type(getattr(found, name)) not in known:
            raise ValueError(f'{name} = {getattr(found, name)!r} has the wrong type')
    if any(type(level) is not int for level in found.hints):
        raise ValueError(f'hints = {found.hints!r} is not a list of levels')
    return found


def _texts(table: dict[Any, Any]) -> dict[Any, str]:
    """Return a table of strings. Raise ValueError if a value is not a string."""
    for name, text in table.items():
        if not isinstance(text, str):
            raise ValueError(f'{name} = {text!r} is not a string')
    return table


def _key(name: str) -> str:
    return name if _BARE.fullmatch(name) else json.dumps(name, ensure_ascii=False)


def _lines(name: str, table: dict[str, Any]) -> str:
    """Format a table of strings or of lists of strings as TOML. An empty table gives ''."""
    lines = [f'{_key(key)} = {json.dumps(value, ensure_ascii=False)}\n' for key, value in table.items()]
    return f'\n[{name}]\n{"".join(lines)}' if lines else ''


def _table(name: str, item: Progress) -> str:
    done = 'true' if item.done else 'false'
    return (
        f'\n[{_key(name)}]\ndone = {done}\nattempts = {item.attempts}\nhints = {item.hints}\n'
        f'best_points = {item.best_points}\npoints = {item.points}\n'
        + ''.join(f'{key} = "{text}"\n' for key, text in (('first', item.first), ('last', item.last)) if _BARE.fullmatch(text))
    )
