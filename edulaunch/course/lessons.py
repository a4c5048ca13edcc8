"""Where a course lies (around the current folder, a given one, or ours, which comes with edulaunch), and its lessons as data.

Notes for teachers are ``lessons/notes/NN_name.md``: never handed out to students.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable
from typing import NamedTuple

from edugrade.course import MANIFEST, Exercise, here_and_above, read_course

from edulaunch.engine.nearest import nearest
from edulaunch.errors import UnusableInput

from .notebook_file import read_notebook

LESSONS, EXERCISES = 'lessons', 'exercises'
_HERE = os.path.dirname(os.path.abspath(__file__))


def our_course() -> str:
    """The folder of the course that comes with edulaunch: inside the installed package, or the source tree."""
    inside = os.path.join(_HERE, 'ours')
    return inside if os.path.isdir(inside) else os.path.dirname(os.path.dirname(_HERE))


def manifest(folder: str) -> str | None:
    """The course.toml of a course: in its folder, or in ``exercises`` there; None when there is none."""
    places = (os.path.join(folder, MANIFEST), os.path.join(folder, EXERCISES, MANIFEST))
    return next((place for place in places if os.path.isfile(place)), None)


def has_manifest(folder: str) -> bool:
    """Whether there is a manifest in the folder, readable or not."""
    return any(os.path.isfile(os.path.join(folder, *place)) for place in ((MANIFEST,), (EXERCISES, MANIFEST)))


def given_course(folder: str) -> str:
    """The folder, when there is a course in it.

    :raises UnusableInput: when there is none.
    """
    if manifest(folder) is None:
        help = f'`edulaunch course new DIR` makes a course with all its parts; {MANIFEST} names its exercises'
        raise UnusableInput(f'there is no course in {folder}: neither {MANIFEST} nor {EXERCISES}/{MANIFEST}', help=help)
    return folder


def course_around(folder: str) -> str:
    """The course in this folder or above it, else ours."""
    courses = (above for above in here_and_above(folder) if manifest(above) is not None and os.path.basename(above) != EXERCISES)
    return next(courses, None) or our_course()


_PREDICTS = re.compile(r"^predict\('([\w-]+)'", re.MULTILINE)


class Lesson(NamedTuple):
    """A notebook.

    :param name: its file name without the ending.
    :param title: its first heading.
    :param predictions: the names of the predictions that it asks for.
    """

    name: str
    title: str
    predictions: tuple[str, ...]


def lessons_folder() -> str | None:
    """The folder with notebooks: this one, or ``lessons`` in it; None when neither has any."""
    for folder in (os.getcwd(), os.path.join(os.getcwd(), 'lessons')):
        if os.path.isdir(folder) and any(map(_is_lesson, os.listdir(folder))):
            return folder
    return None


def read_lessons(folder: str) -> list[Lesson]:
    """The lessons of a folder in their order. A notebook that cannot be read counts by its name alone."""
    return [_lesson(folder, name) for name in sorted(filter(_is_lesson, os.listdir(folder)))]


def the_one(given: str, known: Iterable[str], refusal: str) -> str:
    """The name of the lesson that is meant: a number or the beginning of it is enough.

    :raises UnusableInput: with the refusal, when it is none of those known, or several.
    """
    fitting = [name for name in known if name.startswith(os.path.basename(given).removesuffix('.ipynb').zfill(2))]
    if len(fitting) == 1:
        return fitting[0]
    near = nearest(given, known)
    raise UnusableInput(refusal, help=f'did you mean {near}?' if near else f'There are: {", ".join(known)}')


def _is_lesson(name: str) -> bool:
    return name.endswith('.ipynb') and name[:1].isdigit()


def _lesson(folder: str, file: str) -> Lesson:
    name = file.removesuffix('.ipynb')
    try:
        cells = [cell.source for cell in read_notebook(os.path.join(folder, file)).cells]
    except UnusableInput:
        return Lesson(name, name, ())
    heading = next((cell.split('\n')[0] for cell in cells if cell.startswith('# ')), name)
    return Lesson(name, heading.lstrip('# ').strip(), tuple(found for cell in cells for found in _PREDICTS.findall(cell)))


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


FOLDER = 'notes'
_NONE = (
    'those of our course are in the source of edulaunch, not in what is installed;'
    f' of your own course write {LESSONS}/{FOLDER}/01_name.md for 01_name.ipynb'
)
_ROW = re.compile(r'^\| *(\d+) *\| *(.+?) *\|', re.MULTILINE)


def read_notes(course: str) -> dict[str, str]:
    """The notes of a course, Markdown by the name of the lesson, in their order.

    :raises UnusableInput: when one cannot be read.
    """
    folder = os.path.join(course, LESSONS, FOLDER)
    found = {}
    for name in sorted(os.listdir(folder)) if os.path.isdir(folder) else []:
        if name.endswith('.md'):
            try:
                with open(os.path.join(folder, name), encoding='utf-8') as file:
                    found[name.removesuffix('.md')] = file.read()
            except (OSError, ValueError) as error:
                raise UnusableInput(f'the notes {os.path.join(folder, name)} cannot be read: {error}') from None
    return found


def time_plan(notes: str) -> list[tuple[int, str]]:
    """The rows of a time plan: minutes, and the heading of the section. A row is ``| 5 | 1.1 Heading | what |``."""
    return [(int(minutes), section) for minutes, section in _ROW.findall(notes)]


def notes_of(course: str, name: str) -> str:
    """The notes on one lesson; a number or the beginning of its name is enough.

    :raises UnusableInput: when there are none.
    """
    known = read_notes(course)
    if not known:
        raise UnusableInput(f'there are no notes on {name}', help=_NONE)
    return known[the_one(name, known, f'there are no notes on {name}')]


def list_of_notes(course: str) -> str:
    """One line for each lesson that has notes: its minutes, and what the notes are called."""
    known = read_notes(course)
    if not known:
        raise UnusableInput(f'{course} has no notes for teachers', help=_NONE)
    width = max(map(len, known))
    return '\n'.join(
        f'{name:<{width}}  {sum(minutes for minutes, _ in time_plan(text)):>3} minutes' for name, text in known.items()
    )
