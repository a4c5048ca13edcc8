"""`edulaunch course lint`: what all lessons of a course have in common, without running them."""

from __future__ import annotations

import json
import os
import re
from collections import Counter
from collections.abc import Iterator
from typing import Any

from edulaunch.errors import UnusableInput

from .lessons import FOLDER as NOTES
from .lessons import LESSONS, read_lessons, read_notes
from .questions import FILE, Explanation, Question, questions_file, read_questions
from .stored import read_outputs

CELLS = ('code', 'markdown', 'raw')
_ID = re.compile(r'[a-z][a-z0-9]*(-[a-z0-9]+)*')
_ASKS = re.compile(r"^(quiz|explain)\('([\w-]+)'", re.MULTILINE)


def lesson_problems(course: str) -> Iterator[str]:
    """What is wrong with the lessons of a course, one line each; nothing when it has none."""
    folder = os.path.join(course, LESSONS)
    if not os.path.isdir(folder):
        return
    lessons = [lesson.name for lesson in read_lessons(folder)]
    asked: set[tuple[str, str]] = set()
    for name in lessons:
        cells, problem = _cells(os.path.join(folder, f'{name}.ipynb'))
        problems = [problem] if problem else [*_form(cells), *_kept(os.path.join(folder, f'{name}.ipynb'), cells)]
        yield from (f'{LESSONS}/{name}.ipynb: {text}' for text in problems)
        asked.update(found for cell in cells for found in _ASKS.findall(_source(cell)))
    if lessons and not os.path.isfile(os.path.join(folder, 'conftest.py')):
        yield f'{LESSONS}/conftest.py is missing: nbval needs "from edulaunch.course.stored import pytest_itemcollected" in it'
    yield from _questions(folder, lessons, asked)
    strays = [name for name in read_notes(course) if name not in lessons]
    yield from (f'{LESSONS}/{NOTES}/{name}.md: there is no lesson of this name' for name in strays)


def _cells(path: str) -> tuple[list[dict[str, Any]], str]:
    """The cells of a notebook, and what is wrong with it as a whole."""
    try:
        with open(path, encoding='utf-8') as file:
            cells = json.load(file)['cells']
        for number, cell in enumerate(cells, 1):
            if not isinstance(cell.get('id', ''), str) or cell['cell_type'] not in CELLS or not isinstance(_source(cell), str):
                return [], f'its cell number {number} is none of Jupyter'
    except KeyError as error:
        return [], f'it is no notebook: it lacks {error}'
    except (OSError, ValueError, TypeError, AttributeError, RecursionError) as error:
        return [], f'it cannot be read as a notebook: {error}'
    return cells, ''


def _source(cell: dict[str, Any]) -> str:
    return ''.join(cell['source'])


def _form(cells: list[dict[str, Any]]) -> Iterator[str]:
    if not cells or not _source(cells[0]).startswith('# '):
        yield 'it does not begin with a heading "# Title"'
    ids = [cell.get('id', '') for cell in cells]
    yield from (f'the cell id "{ident}" is there {count} times' for ident, count in Counter(ids).items() if count > 1)
    yield from (f'the cell id "{ident}" is not made of words like see-the-turtle' for ident in ids if not _ID.fullmatch(ident))
    full = [cell.get('id', '?') for cell in cells if cell.get('outputs') or cell.get('execution_count')]
    if full:
        yield f'it has outputs, which students would get (first in the cell {full[0]}); `edulaunch course store` keeps them apart'


def _kept(path: str, cells: list[dict[str, Any]]) -> Iterator[str]:
    """Whether each code cell has its kept outputs, and nothing is kept of cells that are gone."""
    try:
        kept = set(read_outputs(path))
    except UnusableInput as error:
        yield str(error)
        return
    code = [cell.get('id', '') for cell in cells if cell['cell_type'] == 'code']
    yield from (f'nothing is kept of what the cell {ident} gives' for ident in code if ident not in kept)
    yield from (f'outputs are kept of the cell {ident}, which is gone' for ident in sorted(kept - set(code)))


def _questions(folder: str, lessons: list[str], asked: set[tuple[str, str]]) -> Iterator[str]:
    try:
        questions, explanations = read_questions(questions_file(folder))
    except UnusableInput as error:
        yield str(error)
        return
    kinds = {'quiz': 'question', 'explain': 'explanation'}
    known: dict[tuple[str, str], Question | Explanation] = {('quiz', name): item for name, item in questions.items()}
    known.update({('explain', name): item for name, item in explanations.items()})
    for call, name in sorted(asked - set(known), reverse=True):
        yield f'{LESSONS}/{FILE} has no {kinds[call]} "{name}", which a lesson asks'
    for (call, name), item in known.items():
        if item.lesson not in lessons:
            yield f'{LESSONS}/{FILE}: the {kinds[call]} "{name}" names the lesson {item.lesson}, which is not there'
