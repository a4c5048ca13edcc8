"""What of the seed tutorials our lessons teach, from lessons/coverage.toml: `python -m tests.lessons.coverage`
writes docs/coverage*.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import NamedTuple

from tests.lessons.notebook import LESSONS, ORDER, Lesson

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

TABLE = LESSONS / 'coverage.toml'
DOCS = LESSONS.parent / 'docs'
TITLES = {
    'launch_lesson': 'Launch files and parameters (a lesson)',
    'launch_advanced': 'Launch files, advanced',
    'launch_and_parameters': 'Launch files and parameter management',
    'large_projects': 'Using ROS 2 launch for large projects',
    'tf2_book': 'Transform library (a chapter of a book)',
}
HEAD = """# What the lessons cover

This course began with five public tutorials. For each part of a tutorial, these pages name the sections of our lessons that teach it, or the
reason why none does. `python -m tests.lessons.coverage` writes them from `lessons/coverage.toml`. Tests check that each section exists, and that
the table contains every part, listing and command. They do not judge how well a section teaches it.
"""
SUBHEAD = (
    'This table lists parts of public tutorials, and the sections of our lessons that teach them; '
    'see [What the lessons cover](../coverage.md). A number such as *1.2* means section 2 of lesson 1.'
)


class Part(NamedTuple):
    """One part of a tutorial, a listing or a command, and its place."""

    heading: str
    cells: tuple[str, ...]
    reason: str
    missing: str
    note: str

    @property
    def remark(self) -> str:
        """What the page says besides the place."""
        missing = f'**missing:** {self.missing}' if self.missing else ''
        return '; '.join(text for text in (self.reason and f'left out: {self.reason}', missing, self.note) if text)


def _part(heading: str, row: dict[str, str]) -> Part:
    unknown = set(row) - {'heading', 'cells', 'reason', 'missing', 'note'}
    if unknown:
        raise ValueError(f'{heading}: unknown keys {sorted(unknown)}')
    return Part(heading, tuple(row.get('cells', '').split()), row.get('reason', ''), row.get('missing', ''), row.get('note', ''))


def seeds() -> dict[str, list[Part]]:
    """The parts of each tutorial, in the order of its text."""
    table = tomllib.loads(TABLE.read_text('utf-8'))['seeds']
    return {seed: [_part(row['heading'], row) for row in rows] for seed, rows in table.items()}


def listings() -> list[Part]:
    """The listings of the tutorials."""
    return [_part(name, row) for name, row in tomllib.loads(TABLE.read_text('utf-8'))['files'].items()]


def commands() -> list[Part]:
    """The commands of the tutorials, by how they begin."""
    return [_part(name, row) for name, row in tomllib.loads(TABLE.read_text('utf-8'))['commands'].items()]


def everything() -> Iterator[Part]:
    """All parts, listings and commands."""
    for parts in seeds().values():
        yield from parts
    yield from listings()
    yield from commands()


@cache
def places() -> dict[str, tuple[list[str], str]]:
    """Each cell as LESSON/CELL: the sections in which it stands, and its source."""
    found = {}
    for name in ORDER:
        section = f'start of lesson {int(name[:2])}'
        for cell in Lesson(name).cells:
            headings = re.findall(r'(?m)^## (.+)$', cell.source) if cell.kind == 'markdown' else []
            sections = [] if cell.source.startswith('## ') else [section]
            sections += [_section(heading, name) for heading in headings]
            found[f'{name[:2]}/{cell.id}'] = (sections, cell.source)
            section = sections[-1]
    return found


def _section(heading: str, lesson: str) -> str:
    number = re.match(r'\d+\.\d+ ', heading)
    return number[0].strip() if number else f'end of lesson {int(lesson[:2])}'


def pages() -> dict[str, str]:
    """Return the content of each page by its path in docs/."""
    found = {f'coverage/{seed}.md': _page(TITLES[seed], 'part', [part._replace(heading=_short(part.heading)) for part in parts]) for seed, parts in seeds().items()}
    text = [HEAD, '| tutorial | parts | in a lesson | left out, with a reason | with something missing |', '|---|---|---|---|---|']
    text += [_count(f'[{TITLES[seed]}](coverage/{seed}.md)', parts) for seed, parts in seeds().items()]
    for name, rows in (('listing', listings()), ('command', commands())):
        title = f'{name.capitalize()}s of the five tutorials'
        found[f'coverage/{name}s.md'] = _page(title, name, [part._replace(heading=f'`{part.heading}`') for part in rows])
        text.append(_count(f'[{title}](coverage/{name}s.md)', rows))
    return {'coverage.md': '\n'.join(text) + '\n', **found}


def _page(title: str, what: str, parts: list[Part]) -> str:
    return '\n'.join([f'# {title}', '', SUBHEAD, '', *_table(what, parts)]) + '\n'


def _count(title: str, parts: list[Part]) -> str:
    kinds = [
        sum(bool(value) for value in column) for column in zip(*[(p.cells, p.reason, p.missing) for p in parts], strict=True)
    ]
    return f'| {title} | {len(parts)} | {kinds[0]} | {kinds[1]} | {kinds[2]} |'


def _short(heading: str) -> str:
    return heading.strip().rstrip(':')


def _table(what: str, parts: list[Part]) -> Iterator[str]:
    yield f'| {what} | where | remark |'
    yield '|---|---|---|'
    for part in parts:
        yield f'| {part.heading} | {", ".join(_where(part.cells))} | {part.remark} |'


def _where(cells: tuple[str, ...]) -> list[str]:
    """Sections rather than cells, each once; a cell that ends one section and begins the next is in both."""
    shown = [section for cell in cells for section in ([f'`{cell}`'] if cell.startswith('exercises/') else places()[cell][0])]
    return list(dict.fromkeys(shown))


def source(cell: str) -> str:
    """What stands in a cell, or in a file of exercises/."""
    return Path(LESSONS.parent, cell).read_text('utf-8') if cell.startswith('exercises/') else places()[cell][1]


if __name__ == '__main__':
    (DOCS / 'coverage').mkdir(exist_ok=True)
    for name, text in pages().items():
        (DOCS / name).write_text(text, 'utf-8')
