"""The manifest of a course, course.toml. It lists the exercises in order, with their hints."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable, Iterator, Mapping
from functools import lru_cache
from types import MappingProxyType
from typing import Any, NamedTuple

from edulaunch.errors import UnusableInput

from .faults import raise_fault
from .submission import exercise_of

LEVELS = 3
MANIFEST = 'course.toml'
HIGHEST = 6  # most folders, from the submission's folder upwards, in which the manifest is searched
_BESIDE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
_OURS = (os.path.join(_BESIDE, 'edulaunch', 'course', 'ours', 'exercises'), os.path.join(os.path.dirname(_BESIDE), 'exercises'))


class Exercise(NamedTuple):
    """An entry of the manifest.

    :param file: the launch file, relative to exercises/ and to solutions/. If it is in a directory, this is the exercise's
        package.
    :param title: the title of the exercise.
    :param lesson: the notebook, without its ending, after which students can do the exercise; '' without lessons.
    :param points: the sum of the points of all checks.
    :param hints: LEVELS strings: a question, the place to look at, and almost the answer.
    :param why: one sentence on why the exercise matters on a robot, or ''.
    :param check_points: the points of checks for which the course replaces the points of the rubric, by the check's name.
    :param variants: rows of strings. Each student gets one string of each row, and the first string is the usual string. See
        `variant`.
    """

    file: str
    title: str
    lesson: str
    points: int
    hints: tuple[str, ...]
    why: str = ''
    check_points: Mapping[str, int] = MappingProxyType({})
    variants: tuple[tuple[str, ...], ...] = ()

    @property
    def name(self) -> str:
        """The name of the exercise and of its rubric, such as ``circle``."""
        return exercise_of(os.path.basename(self.file))

    @property
    def path(self) -> str:
        """The path of the starter file or of the starter package's directory, relative to exercises/."""
        return self.file.split('/')[0]


def read_toml(path: str) -> dict[str, Any]:
    """Return the tables of a TOML file.

    :raises OSError: if the file cannot be read.
    :raises ValueError: if the content is not valid TOML.
    """
    with open(path, encoding='utf-8') as file:
        return parse_toml(file.read())


def parse_toml(text: str) -> dict[str, Any]:
    """Return the tables of a TOML string.

    :raises ValueError: if the string is not valid TOML.
    """
    if sys.version_info >= (3, 11):
        import tomllib
    else:
        import tomli as tomllib
    tables: dict[str, Any] = tomllib.loads(text)
    return tables


def read_course(path: str) -> list[Exercise]:
    """Return the exercises of a manifest, in the order of the course.

    :raises UnusableInput: if the manifest cannot be read, or an entry lacks a field, which the message names.
    """
    try:
        with open(path, encoding='utf-8') as file:
            return list(_exercises_of(file.read()))
    except KeyError as error:
        raise UnusableInput(f'an entry of the manifest {path} lacks {error}') from None
    except (OSError, ValueError, TypeError) as error:
        raise_fault(error)
        why = getattr(error, 'strerror', None) or error
        raise UnusableInput(
            f'the manifest {path} cannot be read: {why}', help='run the command in the folder of a course'
        ) from None


@lru_cache(maxsize=4)
def _exercises_of(text: str) -> tuple[Exercise, ...]:
    """Return the exercises of a manifest's content.

    The result is cached: a batch calls this for each submission, and parsing would take longer than planning the work.
    """
    return tuple(
        Exercise(
            entry['file'],
            entry['title'],
            entry.get('lesson', ''),
            entry['points'],
            tuple(entry.get('hints', ())),
            entry.get('why', ''),
            entry.get('check_points', {}),
            tuple(tuple(map(str, row)) for row in entry.get('variants', ())),
        )
        for entry in parse_toml(text)['exercise']
    )


def here_and_above(folder: str) -> Iterator[str]:
    """Yield a folder and its parents, up to HIGHEST folders. Parts of a course are searched in these folders."""
    folder = os.path.abspath(folder)
    for _ in range(HIGHEST):
        yield folder
        folder = os.path.dirname(folder)


def course_manifest(inside: str = '') -> str | None:
    """Return the course.toml of the course around a directory (default: the current directory), or None if there is no
    manifest.
    """
    places = (place for folder in here_and_above(inside) for place in (folder, os.path.join(folder, 'exercises')))
    return _manifest_of(places)


def find_course(folder: str) -> str:
    """Return the manifest in this folder or a parent. Otherwise, return the manifest of edulaunch's own course.

    :raises UnusableInput: if there is no manifest.
    """
    path = course_manifest(folder) or _manifest_of(_OURS)
    if path is None:
        raise UnusableInput(f'there is no {MANIFEST}', help='restore the file, which is part of the folder exercises/')
    return path


def _manifest_of(places: Iterable[str]) -> str | None:
    return next(filter(os.path.isfile, (os.path.join(place, MANIFEST) for place in places)), None)
