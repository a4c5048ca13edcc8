"""`edulaunch course lint`: check the form that all lessons of a course share, without running them."""

from __future__ import annotations

import os
import re
from collections import Counter
from collections.abc import Iterator, Sequence

from edulaunch.errors import UnusableInput

from .lessons import FOLDER as NOTES
from .lessons import LESSONS, read_lessons, read_notes
from .notebook_file import Cell, read_notebook
from .questions import FILE, SOLUTIONS, Explanation, Question, questions_file, read_questions
from .stored import read_outputs

_ID = re.compile(r'[a-z][a-z0-9]*(-[a-z0-9]+)*')
_ASKS = re.compile(r"^(quiz|explain)\('([\w-]+)'", re.MULTILINE)


def lesson_problems(course: str) -> Iterator[str]:
    """Yield one line for each problem of a course's lessons. Yield nothing for a course without lessons."""
    folder = os.path.join(course, LESSONS)
    if not os.path.isdir(folder):
        return
    lessons = [lesson.name for lesson in read_lessons(folder)]
    asked: set[tuple[str, str]] = set()
    for name in lessons:
        path = os.path.join(folder, f'{name}.ipynb')
        try:
            cells = read_notebook(path).cells
        except UnusableInput as error:
            yield str(error).split('\n')[0].replace(path, f'{LESSONS}/{name}.ipynb')
            continue
        yield from (f'{LESSONS}/{name}.ipynb: {text}' for text in (*_form(cells), *_kept(path, cells)))
        asked.update(found for cell in cells for found in _ASKS.findall(cell.source))
    if lessons and not os.path.isfile(os.path.join(folder, 'conftest.py')):
        yield f'{LESSONS}/conftest.py is missing: nbval needs "from edulaunch.course.stored import pytest_itemcollected" in it'
    yield from _questions(folder, lessons, asked)
    strays = [name for name in read_notes(course) if name not in lessons]
    yield from (f'{LESSONS}/{NOTES}/{name}.md: there is no lesson of this name' for name in strays)


def _form(cells: Sequence[Cell]) -> Iterator[str]:
    if not cells or not cells[0].source.startswith('# '):
        yield 'it does not begin with a heading "# Title"'
    ids = [cell.ident for cell in cells]
    yield from (f'the cell id "{ident}" appears {count} times' for ident, count in Counter(ids).items() if count > 1)
    yield from (f'the cell id "{ident}" must consist of words like see-the-turtle' for ident in ids if not _ID.fullmatch(ident))
    full = [cell.ident or '?' for cell in cells if cell.outputs or cell.counted]
    if full:
        yield f'it has outputs, which students would get (first in the cell {full[0]}); use `edulaunch course store`'


def _kept(path: str, cells: Sequence[Cell]) -> Iterator[str]:
    """Check that each code cell has stored outputs, and that no outputs belong to deleted cells."""
    try:
        kept = set(read_outputs(path))
    except UnusableInput as error:
        yield str(error)
        return
    code = [cell.ident for cell in cells if cell.kind == 'code']
    yield from (f'the cell {ident} has no stored outputs' for ident in code if ident not in kept)
    yield from (f'the outputs of a missing cell {ident} are stored' for ident in sorted(kept - set(code)))


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
        yield f'{SOLUTIONS}/{FILE} has no {kinds[call]} "{name}", which a lesson uses'
    for (call, name), item in known.items():
        if item.lesson not in lessons:
            yield f'{SOLUTIONS}/{FILE}: the {kinds[call]} "{name}" names the lesson {item.lesson}, which does not exist'
