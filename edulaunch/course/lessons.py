"""The lessons of a course as data: their titles, and what they ask."""

from __future__ import annotations

import json
import os
import re
from typing import NamedTuple

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


def _is_lesson(name: str) -> bool:
    return name.endswith('.ipynb') and name[:1].isdigit()


def _lesson(folder: str, file: str) -> Lesson:
    name = file.removesuffix('.ipynb')
    try:
        with open(os.path.join(folder, file), encoding='utf-8') as notebook:
            cells = [''.join(cell['source']) for cell in json.load(notebook)['cells']]
    except (OSError, ValueError, KeyError, TypeError):
        return Lesson(name, name, ())
    heading = next((cell.split('\n')[0] for cell in cells if cell.startswith('# ')), name)
    return Lesson(name, heading.lstrip('# ').strip(), tuple(found for cell in cells for found in _PREDICTS.findall(cell)))
