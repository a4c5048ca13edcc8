"""The hints of an exercise: three levels, kept in the manifest of the course, course.toml."""

from __future__ import annotations

import os
import sys
from typing import Any

from edulaunch.errors import UnusableInput

from .submission import Submission, exercise_of

LEVELS = 3
MANIFEST = 'course.toml'
_HERE = os.path.dirname(os.path.abspath(__file__))


def read_course(path: str) -> list[dict[str, Any]]:
    """The exercises of a manifest, in the order of the course: file, title, points, lesson and hints of each.

    :raises UnusableInput: when the manifest cannot be read.
    """
    if sys.version_info >= (3, 11):
        import tomllib
    else:
        import tomli as tomllib
    try:
        with open(path, 'rb') as file:
            return list(tomllib.load(file)['exercise'])
    except (OSError, ValueError, KeyError) as error:
        raise UnusableInput(f'the manifest {path} cannot be read: {error}') from None


def find_course(folder: str) -> str:
    """The manifest: beside the launch file, else the one that came with edugrade."""
    places = [folder, _HERE, os.path.join(_HERE, '..', '..', 'exercises')]
    for place in places:
        path = os.path.join(place, MANIFEST)
        if os.path.isfile(path):
            return path
    raise UnusableInput(
        f'there is no {MANIFEST} with hints', help='hints come with the files of the folder exercises/'
    )


def find_hint(submission: Submission, level: int) -> str:
    """A hint for the exercise that this file belongs to.

    :raises UnusableInput: when there is no manifest, or no such exercise in it.
    """
    known = read_course(find_course(submission.folder))
    for exercise in known:
        if exercise_of(exercise['file']) == submission.exercise:
            return f'{exercise["title"]}, hint {level} of {LEVELS}: {exercise["hints"][level - 1]}'
    raise UnusableInput(
        f'there is no exercise {submission.exercise}',
        help='exercises: ' + ', '.join(exercise['file'] for exercise in known),
    )
