"""`edulaunch course list`: the lessons of a course, each with the exercises that can be done after it."""

from __future__ import annotations

import os

from edugrade.course import Exercise, read_course

from .lessons import read_lessons
from .place import LESSONS, manifest


def contents(course: str) -> str:
    """The lessons in their order, each with its exercises; those of no lesson stand at the end.

    :raises UnusableInput: when the manifest cannot be read.
    """
    path, folder = manifest(course), os.path.join(course, LESSONS)
    exercises = read_course(path) if path else []
    lessons = read_lessons(folder) if os.path.isdir(folder) else []
    lines = []
    for lesson in lessons:
        lines += [f'{lesson.name}: {lesson.title}', *(_line(item) for item in exercises if item.lesson == lesson.name)]
    names = {lesson.name for lesson in lessons}
    others = [_line(item) for item in exercises if item.lesson not in names]
    return '\n'.join([*lines, *(['exercises'] if others else []), *others])


def _line(exercise: Exercise) -> str:
    line = f'    {exercise.name:<18} {exercise.points:>3} points  {exercise.title}'
    return f'{line}\n{" " * 23}{exercise.why}' if exercise.why else line
