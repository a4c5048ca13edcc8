"""Notes for teachers, ``lessons/notes/NN_name.md``: never handed out to students."""

from __future__ import annotations

import os
import re

from edulaunch.errors import UnusableInput
from edulaunch.nearest import nearest

from .place import LESSONS

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
    fitting = [lesson for lesson in known if lesson.startswith(name.removesuffix('.ipynb').zfill(2))]
    if len(fitting) == 1:
        return known[fitting[0]]
    near = nearest(name, known)
    there = f'did you mean {near}?' if near else f'There are: {", ".join(known)}'
    raise UnusableInput(f'there are no notes on {name}', help=there if known else _NONE)


def list_of_notes(course: str) -> str:
    """One line for each lesson that has notes: its minutes, and what the notes are called."""
    known = read_notes(course)
    if not known:
        raise UnusableInput(f'{course} has no notes for teachers', help=_NONE)
    width = max(map(len, known))
    return '\n'.join(
        f'{name:<{width}}  {sum(minutes for minutes, _ in time_plan(text)):>3} minutes' for name, text in known.items()
    )
