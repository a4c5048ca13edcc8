"""Fifteen features of a good lesson on launch and tf2, lesson by lesson: `python -m tests.lessons.features` writes docs/features.md."""

from __future__ import annotations

import re
import sys
from collections.abc import Callable
from typing import NamedTuple

from tests.lessons.notebook import LESSONS, ORDER, Cell, Lesson

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

PAGE = LESSONS.parent / 'docs' / 'features.md'
HEAD = """# What a lesson has

We found these fifteen features in the best lessons on launch and tf2. No lesson had all of them. The first table counts the cells
of our lessons that have a feature. A `-` means that a lesson does not have it. The second table names the
first cell of each lesson, and the tests that fail without the feature. `python -m tests.lessons.features` writes this page.
Feature 7: the views show the same time. Selecting a frame in one view does not select it in the others.
"""

Shown = Callable[[Lesson], list[str]]


class Feature(NamedTuple):
    """One feature: its name, how it is told in a lesson, and the tests that hold it."""

    name: str
    shown: Shown
    tests: tuple[str, ...]
    least: int
    """In how many lessons it has to be."""


def _code(pattern: str) -> Shown:
    """The code cells whose source has it."""
    return lambda lesson: [cell.id for cell in lesson.code if re.search(pattern, cell.source, re.MULTILINE)]


def _text(pattern: str) -> Shown:
    """The text cells that have it."""
    return lambda lesson: [cell.id for cell in _texts(lesson) if re.search(pattern, cell.source, re.MULTILINE)]


def _texts(lesson: Lesson) -> list[Cell]:
    return [cell for cell in lesson.cells if cell.kind == 'markdown']


def _told(pattern: str) -> Shown:
    """The code cells below which it stands."""
    return lambda lesson: [cell.id for cell in lesson.code if re.search(pattern, cell.text)]


def _broken(lesson: Lesson) -> list[str]:
    """The code cells of the sections in which something is wrong."""
    inside, found = False, []
    for cell in lesson.cells:
        if cell.kind == 'markdown' and re.search(r'^## ', cell.source, re.MULTILINE):
            inside = re.search(r'^## .*([Ww]rong|[Ss]ilent|[Pp]atient)', cell.source, re.MULTILINE) is not None
        elif inside and cell.kind == 'code':
            found.append(cell.id)
    return found


def _pictures(lesson: Lesson) -> list[str]:
    """The cells with a picture; each has its text."""
    return [cell.id for cell in lesson.code if any('image/png' in one.get('data', {}) for one in cell.outputs)]


def _predicted(lesson: Lesson) -> list[str]:
    """The predictions that a later cell compares with what happened."""
    names = re.compile(r"(predict|compare)\('([\w-]+)'")
    found = [(cell.id, *pair) for cell in lesson.code for pair in names.findall(cell.source)]
    compared = {name for _, what, name in found if what == 'compare'}
    return [ident for ident, what, name in found if what == 'predict' and name in compared]


def _exercises(lesson: Lesson, key: str = '') -> list[str]:
    """The exercises of a lesson, all or those that have something."""
    table = tomllib.loads((LESSONS.parent / 'exercises' / 'course.toml').read_text('utf-8'))['exercise']
    of_it = [row for row in table if str(row.get('lesson', '')).removesuffix('.ipynb').endswith(lesson.name)]
    return [row['file'] for row in of_it if not key or row.get(key)]


FEATURES = [
    Feature(
        'one installation with pip, without ROS or windows; also in a browser tab',
        _code(r'load_ext edulaunch'),
        ('tests/test_packaging.py', 'tests/browser/test_lite.py'),
        18,
    ),
    Feature(
        'predict, run, explain: the lesson stores and compares predictions',
        _predicted,
        ('tests/course/test_predictions.py', 'tests/browser/test_lessons.py'),
        18,
    ),
    Feature(
        'checks in a cell that are the same as on the command line',
        _code(r'^(edulaunch\.)?check\('),
        ('tests/lessons/test_your_turn.py', 'tests/lessons/test_gaps.py'),
        18,
    ),
    Feature(
        'error messages in ROS terms, with place and suggestion',
        _told(r'help: |try: |expected'),
        ('tests/advice/test_examples.py', 'tests/lessons/test_mistakes.py'),
        17,
    ),
    Feature('three levels of hints', _text(r'Hint 3'), ('tests/grader/reports/test_wording.py',), 18),
    Feature(
        'time that stops, steps and goes back',
        _code(r'%ros2 view|\.replay\(|interact\('),
        ('tests/browser/test_replay.py', 'tests/browser/test_desk.py'),
        12,
    ),
    Feature(
        'linked views of one time: world, frames, graph, timeline, plot, log',
        _code(r'%ros2 view|\.replay\('),
        ('tests/browser/test_desk.py',),
        12,
    ),
    Feature(
        'tf lookups in the past and too early, with the errors of ROS',
        _code(r'frames_at\(|lookup|tf2_echo|view frames'),
        ('tests/browser/test_desk.py', 'tests/ros/underlay/test_tf2_buffer.py'),
        7,
    ),
    Feature(
        'origin of values: arguments, defaults, files, lines',
        _code(r'parameter_table|--show-args| -s$|explain|plan|param (get|describe|dump)|\.origin'),
        ('tests/advice/explaining', 'tests/advice/plan'),
        6,
    ),
    Feature(
        'broken systems to diagnose',
        _broken,
        ('tests/lessons/test_mistakes.py', 'tests/grader/checks/test_small_exercises.py'),
        17,
    ),
    Feature('the real commands of ROS 2', _code(r'%%?ros2 (?!view)'), ('tests/desk/terminals', 'tests/desk/notebook/test_magics.py'), 17),
    Feature(
        'personalised exercises',
        lambda lesson: _exercises(lesson, 'variants'),
        ('tests/grader/test_variant.py',),
        8,
    ),
    Feature(
        'stored progress, and what to repeat',
        _code(r'^(edulaunch\.)?(check|quiz)\(|course\.progress'),
        ('tests/course/test_progress_page.py', 'tests/grader/test_progress_file.py'),
        18,
    ),
    Feature('a description of each picture', _pictures, ('tests/browser/test_lessons.py', 'tests/course/test_reader.py'), 11),
    Feature(
        'differences on a real robot, with the same files',
        _text(r'^## On a real robot'),
        ('tests/extras/network', 'tests/test_docs.py'),
        18,
    ),
]


def table() -> list[list[list[str]]]:
    """By feature and lesson: the cells that show it."""
    lessons = [Lesson(name) for name in ORDER]
    return [[feature.shown(lesson) for lesson in lessons] for feature in FEATURES]


def page() -> str:
    """Return the content of docs/features.md."""
    rows = table()
    text = [HEAD, '| | feature | ' + ' | '.join(name[:2] for name in ORDER) + ' |', '|---|---|' + '---|' * len(ORDER)]
    for number, (feature, row) in enumerate(zip(FEATURES, rows, strict=True), 1):
        text.append(f'| {number} | {feature.name} | ' + ' | '.join(str(len(cells) or '-') for cells in row) + ' |')
    text += ['', '## The evidence', '', '| | first cell of each lesson | tests |', '|---|---|---|']
    for number, (feature, row) in enumerate(zip(FEATURES, rows, strict=True), 1):
        first = ', '.join(f'`{name[:2]}: {cells[0]}`' for name, cells in zip(ORDER, row, strict=True) if cells)
        text.append(f'| {number} | {first} | {", ".join(f"`{test}`" for test in feature.tests)} |')
    return '\n'.join(text) + '\n'


if __name__ == '__main__':
    PAGE.write_text(page(), 'utf-8')
    print(*[f'{number}: {[len(cells) for cells in row]}' for number, row in enumerate(table(), 1)], sep='\n')
