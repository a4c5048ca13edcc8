"""Find a course and read its lessons.

A course is found around the current folder, in a given folder, or in edulaunch. Notes for teachers are in
``lessons/notes/NN_name.md``; students never get them.
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
    """Return the folder of the course that comes with edulaunch, which is in the installed package or in the source tree."""
    inside = os.path.join(_HERE, 'ours')
    return inside if os.path.isdir(inside) else os.path.dirname(os.path.dirname(_HERE))


def manifest(folder: str) -> str | None:
    """Return the course.toml of a course, in its folder or in the subfolder ``exercises``. Return None if there is no such
    file.
    """
    places = (os.path.join(folder, MANIFEST), os.path.join(folder, EXERCISES, MANIFEST))
    return next((place for place in places if os.path.isfile(place)), None)


def has_manifest(folder: str) -> bool:
    """Return whether the folder has a manifest, even if it cannot be read."""
    return any(os.path.isfile(os.path.join(folder, *place)) for place in ((MANIFEST,), (EXERCISES, MANIFEST)))


def given_course(folder: str) -> str:
    """Return the folder if it contains a course.

    :raises UnusableInput: when the folder contains no course.
    """
    if manifest(folder) is None:
        help = f'create a course with `edulaunch course new DIR`; its {MANIFEST} lists the exercises'
        raise UnusableInput(f'there is no course in {folder}: neither {MANIFEST} nor {EXERCISES}/{MANIFEST}', help=help)
    return folder


def course_around(folder: str) -> str:
    """Return the course in this folder or a parent folder, or else the course of edulaunch."""
    courses = (above for above in here_and_above(folder) if manifest(above) is not None and os.path.basename(above) != EXERCISES)
    return next(courses, None) or our_course()


_PREDICTS = re.compile(r"^predict\('([\w-]+)'", re.MULTILINE)


class Lesson(NamedTuple):
    """A lesson, which is a notebook.

    :param name: the file name without its ending.
    :param title: the first heading.
    :param predictions: the names of the predictions in the lesson.
    """

    name: str
    title: str
    predictions: tuple[str, ...]


def lessons_folder() -> str | None:
    """Return the folder with notebooks: this folder, or the subfolder ``lessons``. Return None if neither contains notebooks."""
    for folder in (os.getcwd(), os.path.join(os.getcwd(), 'lessons')):
        if os.path.isdir(folder) and any(map(_is_lesson, os.listdir(folder))):
            return folder
    return None


def read_lessons(folder: str) -> list[Lesson]:
    """Return the lessons of a folder in order. A notebook that cannot be read becomes a lesson with only a name."""
    return [_lesson(folder, name) for name in sorted(filter(_is_lesson, os.listdir(folder)))]


def the_one(given: str, known: Iterable[str], refusal: str) -> str:
    """Return the full name of the lesson with this number, or with a name that begins with this string.

    :raises UnusableInput: with the message `refusal`, if no lesson or more than one lesson matches.
    """
    fitting = [name for name in known if name.startswith(os.path.basename(given).removesuffix('.ipynb').zfill(2))]
    if len(fitting) == 1:
        return fitting[0]
    near = nearest(given, known)
    raise UnusableInput(refusal, help=f'did you mean {near}?' if near else f'choose one of: {", ".join(known)}')


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
    """Return the lessons in order, each with its exercises. Exercises without a lesson come last.

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
    "type the command in a clone of edulaunch, because the installed package has no teachers' notes;"
    f' for your own course, write the notes of 01_name.ipynb into {LESSONS}/{FOLDER}/01_name.md'
)
_ROW = re.compile(r'^\| *(\d+) *\| *(.+?) *\|', re.MULTILINE)


def read_notes(course: str) -> dict[str, str]:
    """Return the notes of a course in order, as Markdown by the name of the lesson.

    :raises UnusableInput: when a file with notes cannot be read.
    """
    folder = os.path.join(course, LESSONS, FOLDER)
    found = {}
    for name in sorted(os.listdir(folder)) if os.path.isdir(folder) else []:
        if name.endswith('.md'):
            try:
                with open(os.path.join(folder, name), encoding='utf-8') as file:
                    found[name.removesuffix('.md')] = file.read()
            except (OSError, ValueError) as error:
                raise UnusableInput(f'cannot read the notes {os.path.join(folder, name)}: {error}') from None
    return found


def time_plan(notes: str) -> list[tuple[int, str]]:
    """Return the rows of a time plan as pairs of minutes and section heading.

    A row in the notes is ``| 5 | 1.1 Heading | what |``.

    """
    return [(int(minutes), section) for minutes, section in _ROW.findall(notes)]


def notes_of(course: str, name: str) -> str:
    """Return the notes on the lesson with this number, or with a name that begins with this string.

    :raises UnusableInput: when the lesson has no notes.
    """
    known = read_notes(course)
    if not known:
        raise UnusableInput(f'there are no notes for the lesson {name}', help=_NONE)
    return known[the_one(name, known, f'the course has no lesson {name} with notes')]


def list_of_notes(course: str) -> str:
    """Return one line for each lesson with notes: the minutes and the title of the notes."""
    known = read_notes(course)
    if not known:
        raise UnusableInput(f'{course} has no notes for teachers', help=_NONE)
    width = max(map(len, known))
    return '\n'.join(
        f'{name:<{width}}  {sum(minutes for minutes, _ in time_plan(text)):>3} minutes' for name, text in known.items()
    )
