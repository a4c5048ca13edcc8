"""What a student does in a lesson, measured on its cells: whose turn it is in each, and how many minutes it takes."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

from tests.lessons.notebook import Cell, Lesson

WORDS_A_MINUTE = 180
MINUTES = {
    'set-up': 0.5,
    'look': 0.5,
    'run': 1.0,
    'compare': 0.5,
    'predict': 1.0,
    'quiz': 1.5,
    'explain': 1.5,
    'drive': 2.0,
    'write': 3.0,
    'turn': 5.0,
    'exercise': 0.0,
}
"""Minutes to read and run a cell of each kind. A `look` is one line, such as a command or a picture; an exercise comes on top of the lesson."""
ASKS = re.compile(r'\*\*(Write|Change|Repair|Try|Add|Drive|Do it|Provoke|Move|Press|Type)\b|^## \d+\.\d+ Your turn', re.MULTILINE)
"""How a text asks the student to do something in a cell near it."""


class Step(NamedTuple):
    """A code cell, and what a student does there."""

    cell: Cell
    kind: str


def kind(cell: Cell, before: str) -> str:
    """What a student does in a code cell; `before` is the text since the code cell in front of it."""
    source = cell.source
    if cell.id == 'set-up':
        return 'set-up'
    if cell.id == 'your-turn-check':
        return 'turn'
    if re.search(r'(?m)^(from edulaunch import check|check\()', source):
        return 'exercise'
    if re.search(r'(?m)^predict\(', source):
        return 'predict'
    if re.search(r'(?m)^quiz\(', source):
        return 'quiz'
    if re.search(r'(?m)^explain\(', source):
        return 'explain'
    if source.startswith('%ros2 view'):
        return 'drive'
    if 'TODO' in source or ASKS.search(before):
        return 'write'
    if re.search(r'(?m)^compare\(', source) and len(cell.lines) <= 2:
        return 'compare'
    return 'look' if len(cell.lines) == 1 else 'run'


def steps(lesson: Lesson) -> Iterator[Step]:
    """The code cells in their order."""
    before = ''
    for cell in lesson.cells:
        if cell.kind == 'markdown':
            before += cell.source + '\n\n'
        else:
            yield Step(cell, kind(cell, before))
            before = ''


def ready_made(lesson: Lesson) -> Iterator[list[str]]:
    """The rows of cells that are only to be run, with nothing to be written, predicted or answered between them."""
    row: list[str] = []
    for step in steps(lesson):
        if step.kind in ('run', 'look'):
            row.append(step.cell.id)
        elif step.kind not in ('compare', 'set-up'):
            yield row
            row = []
    yield row


def minutes(lesson: Lesson) -> float:
    """How long a lesson takes: reading, without what is folded away, and the work in its cells."""
    shown = re.sub(r'(?s)<details>.*?</details>', '', lesson.prose)
    return len(shown.split()) / WORDS_A_MINUTE + sum(MINUTES[step.kind] for step in steps(lesson))


def stated_minutes(lesson: Lesson) -> int:
    """What the lesson says of its length."""
    found = re.search(r'\(about (\d+) minutes\)', lesson.prose)
    assert found, f'{lesson.name} does not say how long it takes'
    return int(found[1])


if __name__ == '__main__':
    from collections import Counter

    from tests.lessons.notebook import ORDER

    for each in map(Lesson, ORDER):
        rows = [row for row in ready_made(each) if len(row) > 3]
        kinds = Counter(step.kind for step in steps(each))
        longest = max(cell.text.count('\n') + 1 for cell in each.code)
        print(
            f'{each.name:30} {minutes(each):5.1f} min, says {stated_minutes(each)}; {dict(kinds)}; longest output {longest}; {rows}'
        )
