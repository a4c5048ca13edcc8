"""The hints of an exercise: three levels, kept in the course.toml beside the exercises."""
from __future__ import annotations

import os
from typing import Any

from edulaunch.errors import UnusableInput

from .submission import Submission

LEVELS = 3
MANIFEST = 'course.toml'


def read_course(path: str) -> list[dict[str, Any]]:
    """The exercises of a manifest, in the order of the course: file, title, points, lesson and hints of each.

    :raises UnusableInput: when the manifest cannot be read.
    """
    try:
        import tomllib
    except ModuleNotFoundError:     # Python 3.10
        import tomli as tomllib
    try:
        with open(path, 'rb') as file:
            return list(tomllib.load(file)['exercise'])
    except (OSError, ValueError, KeyError) as error:
        raise UnusableInput(f'the manifest {path} cannot be read: {error}') from None


def find_hint(submission: Submission, level: int) -> str:
    """A hint for the exercise that this file belongs to.

    :raises UnusableInput: when there is no manifest beside the file, or the file is not in it.
    """
    path = os.path.join(submission.folder, MANIFEST)
    if not os.path.isfile(path):
        raise UnusableInput(f'there are no hints beside {submission.given}: no {MANIFEST} in its folder',
                            help='hints come with the files of the folder exercises/')
    for exercise in read_course(path):
        if exercise['file'] == submission.name:
            return f'{exercise["title"]}, hint {level} of {LEVELS}: {exercise["hints"][level - 1]}'
    raise UnusableInput(f'{path} has no exercise {submission.name}')
