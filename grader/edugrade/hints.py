"""The hints of an exercise: three levels, kept in the manifest of the course."""

from __future__ import annotations

from edulaunch.errors import UnusableInput

from .course import LEVELS, find_course, read_course
from .submission import Submission
from .variant import variant_for


def find_hint(submission: Submission, level: int) -> str:
    """A hint for the exercise that this submission belongs to.

    :param level: 1 asks a question, 2 says where to look, 3 is almost the answer.
    :raises UnusableInput: when there is no manifest, no such exercise in it, or no such level.
    """
    known = read_course(find_course(submission.folder))
    for exercise in known:
        if exercise.name == submission.exercise:
            if not 1 <= level <= len(exercise.hints):
                raise UnusableInput(f'there is no hint of level {level}', help=f'levels are 1 to {len(exercise.hints)}')
            variant, hint = variant_for(exercise.name, '', None), exercise.hints[level - 1]
            return f'{exercise.title}, hint {level} of {LEVELS}: {variant.of(hint) if variant else hint}'
    raise UnusableInput(
        f'there is no exercise {submission.exercise}', help='exercises: ' + ', '.join(exercise.path for exercise in known)
    )
