"""Writes the pages on commands in docs/ from the tutorials that are tried in terminals: `python -m tests.desk.terminals.report`."""

from __future__ import annotations

import re
from collections import Counter
from pathlib import Path

from tests.desk.terminals.pages import Page, Step, pages

DOCS = Path(__file__).resolve().parents[3] / 'docs'
GROUPS = {
    'seeds': 'Five public tutorials',
    'beginner': 'Official tutorials: command line tools',
    'client_libraries': 'Official tutorials: client libraries',
    'tf2_and_demos': 'Official tutorials: tf2 and demos',
}
NOTE = '`python -m tests.desk.terminals.report` writes this page.'


def documents() -> dict[str, str]:
    """Return the content of each page by its path in docs/."""
    found = {f'commands/{group}.md': _group_page(group) for group in GROUPS}
    return {'commands.md': _commands_page(), 'from_a_tutorial.md': _tutorial_page(), **found}


def _commands_page() -> str:
    """Return the page that lists the groups, with how many commands work."""
    lines = [
        '# Commands of the tutorials',
        '',
        'A test types every command of these tutorials into a real terminal, in the order of the tutorial, and checks the output.',
        'Each terminal is prepared as `source .venv/bin/activate` does it.',
        '',
        '| commands of | work word for word | differ | are not offered |',
        '|---|---|---|---|',
        *map(_count, GROUPS),
        '',
        '[From a tutorial](from_a_tutorial.md) lists what to type where a command differs.',
        NOTE,
    ]
    return '\n'.join(lines) + '\n'


def _count(group: str) -> str:
    steps = (step for page in _of(group) for step in page.steps if not step.is_ours)
    words = Counter(re.split('[:,]', step.verdict)[0] for step in steps)
    return f'| [{GROUPS[group]}](commands/{group}.md) | {words["works"]} | {words["differs"]} | {words["not offered"]} |'


def _group_page(group: str) -> str:
    """Return the page with every command of one group, and its result."""
    lines = [f'# {GROUPS[group]}', '', f'[Commands of the tutorials](../commands.md) explains the test. {NOTE}']
    for page in _of(group):
        lines += ['', f'## {page.title}', '', '| command | result |', '|---|---|']
        lines += [f'| {_code(step.says)} | {_cell(step)} |' for step in page.steps if not step.is_ours]
    return '\n'.join(lines) + '\n'


def _of(group: str) -> list[Page]:
    return [page for page in pages() if page.group == group]


def _tutorial_page() -> str:
    """Return the page with what to type where a tutorial has something else."""
    lines = [
        '# From a tutorial',
        '',
        'Follow a ROS 2 tutorial as it is. Type `source .venv/bin/activate` in each terminal, or [put the line into the settings of your',
        'shell](terminals.md#one-line-in-each-terminal) once. `ros2` and the set-up commands (`source`, `colcon`, `rosdep`, `apt`) then work as in the',
        'tutorial. In a terminal where a real ROS 2 is sourced, `ros2` is the real one.',
        '',
        'This table lists the commands that differ. [Commands of the tutorials](commands.md) lists every command that was tested.',
        NOTE,
        '',
        '| the tutorial has | you type | reason |',
        '|---|---|---|',
    ]
    rows = {step.says: step for page in pages() for step in page.steps if step.differs or step.why}
    lines += [
        f'| {_code(step.says)} | {_code(step.type) if step.type else "nothing" if step.why else "the same"} | {step.differs or step.why} |'
        for step in rows.values()
    ]
    return '\n'.join(lines) + '\n'


def _cell(step: Step) -> str:
    return step.verdict + (f' (type {_code(step.type)})' if step.type else '')


def _code(text: str) -> str:
    return '`' + text.replace('|', '\\|') + '`'


if __name__ == '__main__':
    (DOCS / 'commands').mkdir(exist_ok=True)
    for name, text in documents().items():
        (DOCS / name).write_text(text, encoding='utf-8')
