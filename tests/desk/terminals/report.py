"""Writes docs/commands.md and docs/from_a_tutorial.md from the pages that are tried in terminals."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable
from pathlib import Path

from tests.desk.terminals.pages import Page, Step, pages

DOCS = Path(__file__).resolve().parents[3] / 'docs'
COMMANDS_PAGE, TUTORIAL_PAGE = DOCS / 'commands.md', DOCS / 'from_a_tutorial.md'


def commands_page() -> str:
    """Every command with how it goes here."""
    found = list(pages())
    lines = [
        '# Commands of the tutorials',
        '',
        'Made by `python -m tests.desk.terminals.report`; `tests/desk/terminals` types every command into a real terminal, in the order of its',
        'page and with as many terminals as that opens, and looks at what it shows. Each terminal begins with the lines that',
        '`source .venv/bin/activate` brings, too.',
        '',
        *_counts(found),
    ]
    for page in found:
        lines += ['', f'## {page.title}', '', '| command | here |', '|---|---|']
        lines += [f'| {_code(step.says)} | {_cell(step)} |' for step in page.steps if not step.is_ours]
    return '\n'.join(lines) + '\n'


def tutorial_page() -> str:
    """What to type where a page says something else."""
    lines = [
        '# From a tutorial',
        '',
        'Follow a ROS 2 tutorial as it is. Type `source .venv/bin/activate` in each terminal, or [put the line into the settings of your',
        'shell](terminals.md#one-line-in-each-terminal) once. Then `ros2`, and the lines that set up a computer (`source`, `colcon`, `rosdep`,',
        '`apt`), do what they should. In a terminal where a real ROS 2 is sourced, `ros2` is the real one. This table lists the other lines;',
        '[commands.md](commands.md) lists every command that was tried.',
        '',
        '| the page says | you type | why |',
        '|---|---|---|',
    ]
    rows = {step.says: step for page in pages() for step in page.steps if step.differs or step.why}
    lines += [
        f'| {_code(step.says)} | {_code(step.type) if step.type else "nothing" if step.why else "the same"} | {step.differs or step.why} |'
        for step in rows.values()
    ]
    return '\n'.join(lines) + '\n'


def _counts(found: Iterable[Page]) -> list[str]:
    tried = ((page, step) for page in found for step in page.steps if not step.is_ours)
    words = Counter((bool(page.seed), re.split('[:,]', step.verdict)[0]) for page, step in tried)
    rows = (("the official tutorials' pages", False), ('the five seed tutorials', True))
    return [
        '| commands of | works word for word | differs | not offered |',
        '|---|---|---|---|',
        *(f'| {name} | {words[key, "works"]} | {words[key, "differs"]} | {words[key, "not offered"]} |' for name, key in rows),
    ]


def _cell(step: Step) -> str:
    return step.verdict + (f' (type {_code(step.type)})' if step.type else '')


def _code(text: str) -> str:
    return '`' + text.replace('|', '\\|') + '`'


if __name__ == '__main__':
    COMMANDS_PAGE.write_text(commands_page(), encoding='utf-8')
    TUTORIAL_PAGE.write_text(tutorial_page(), encoding='utf-8')
