"""Each part, listing and command of the seed tutorials has a place in a lesson, or lessons/coverage.toml says why not."""

from __future__ import annotations

import ast
import json
import re
from pathlib import Path
from typing import Any

import pytest

from tests.lessons.coverage import DOCS, Part, commands, everything, listings, pages, places, seeds, source
from tests.lessons.notebook import LESSONS

SEEDS = LESSONS.parents[1] / 'shared' / 'seeds'
with_seeds = pytest.mark.skipif(not SEEDS.is_dir(), reason='the seed tutorials are not beside this repository')
HEADINGS = {
    'launch_lesson': r'(Mistake|Question|Task|Step|Example) \d: |(Summary|Setup|Validation|Instructions|Remapping|Namespacing)$',
    'launch_advanced': r'.*¶$',
    'launch_and_parameters': r'(?!.*[()#\[\]{}=,.?!:│├└]|ros2 |Skip )[A-Z][A-Za-z ]+$',
    'large_projects': r'\d(\.\d)? [A-Z]|(Background|Prerequisites|Introduction)$|(Writing|Running) launch files$',
    'tf2_book': r'9\.\d [A-Z]|(Writing|Updating|Adding|Examining|Looking at|Creating|Viewing|Using) (a|the|an)?\s?[A-Z]|Buil?d Run|Build |Run ',
}
"""What a heading looks like in each text: found without coverage.toml, so that it cannot forget one."""
NOT_SHOWN = {'TwistStamped'}
"""Imported by param_circle.py, which the text uses and does not show."""


def lines_of(seed: str) -> list[str]:
    return (SEEDS / 'text' / f'{seed}.txt').read_text('utf-8').split('\n')


def begins(seed: str) -> list[int]:
    """The line at which each part of the table begins, each sought behind the one before."""
    lines, found = lines_of(seed), [-1]
    for part in seeds()[seed]:
        at = (number for number in range(found[-1] + 1, len(lines)) if lines[number].startswith(part.heading))
        number = next(at, None)
        assert number is not None, f'{seed}: no line begins with {part.heading!r} after line {found[-1] + 1}'
        found.append(number)
    return found[1:]


def index() -> list[dict[str, Any]]:
    """The listings that stand in the texts: without what the seeds add, and without shell, which is in commands.txt."""
    rows = json.loads((SEEDS / 'files' / 'index.json').read_text('utf-8'))
    return [row for row in rows if row['seed_lines'] and row['kind'] != 'shell' and '/corrected/' not in row['file']]


def best(command: str) -> Part | None:
    """The longest beginning of a command that the table has."""
    fitting = [part for part in commands() if f'{command} '.startswith(f'{part.heading} ')]
    return max(fitting, key=lambda part: len(part.heading), default=None)


def asked() -> list[str]:
    rows = (SEEDS / 'files' / 'commands.txt').read_text('utf-8').splitlines()
    return [row.partition('\t')[2] for row in rows]


def test_each_entry_has_a_place_or_a_reason() -> None:
    assert [part.heading for part in everything() if bool(part.cells) == bool(part.reason)] == []


def test_each_named_cell_exists() -> None:
    named = {cell for part in everything() for cell in part.cells}
    gone = [
        cell
        for cell in sorted(named - set(places()))
        if not (cell.startswith('exercises/') and Path(LESSONS.parent, cell).is_file())
    ]
    assert gone == []


def test_the_page_is_what_the_table_says() -> None:
    for name, text in pages().items():
        assert (DOCS / name).read_text('utf-8') == text, 'python -m tests.lessons.coverage writes it'


@with_seeds
def test_the_texts_are_these() -> None:
    assert sorted(path.stem for path in (SEEDS / 'text').glob('*.txt')) == sorted(seeds())


@with_seeds
@pytest.mark.parametrize('seed', HEADINGS)
def test_no_line_of_a_text_is_before_the_first_part(seed: str) -> None:
    assert not any(line.strip() for line in lines_of(seed)[: begins(seed)[0]])


@with_seeds
@pytest.mark.parametrize('seed', HEADINGS)
def test_no_heading_of_a_text_is_left_out(seed: str) -> None:
    known = set(begins(seed))
    headings = [number for number, line in enumerate(lines_of(seed)) if re.match(HEADINGS[seed], line)]
    assert len(headings) >= 7
    assert [(number + 1, lines_of(seed)[number][:60]) for number in headings if number not in known] == []


@with_seeds
def test_each_listing_is_there_and_no_other() -> None:
    assert sorted(part.heading for part in listings()) == sorted(row['file'] for row in index())


@with_seeds
def test_each_command_is_there_and_no_other() -> None:
    assert [command for command in asked() if best(command) is None] == []
    used = {part.heading for part in map(best, asked()) if part}
    assert [part.heading for part in commands() if part.heading not in used] == []


@pytest.mark.parametrize('command', [part for part in commands() if part.cells and not part.note], ids=lambda part: part.heading)
def test_a_cell_shows_the_command(command: Part) -> None:
    """Its words, one after the other: also as a list of texts, and with a % in front."""
    words = re.findall(r'[\w./]+', command.heading)
    text = ' '.join(re.findall(r'[\w./]+', ' '.join(map(source, command.cells))))
    assert command.missing or ' '.join(words) in text


@with_seeds
def test_what_the_listings_import_occurs_in_the_lessons() -> None:
    """Every name that a listing takes from a package of ROS."""
    wanted: set[str] = set()
    for row in index():
        if row['file'].endswith('.py') and 'setup.py' not in row['file']:
            wanted |= imported((SEEDS / 'files' / row['file']).read_text('utf-8'))
    prose = '\n'.join(text for _, text in places().values())
    assert len(wanted) > 25
    assert [name for name in sorted(wanted - NOT_SHOWN) if not re.search(rf'\b{name}\b', prose)] == []


def imported(text: str) -> set[str]:
    froms = [node for node in ast.walk(ast.parse(text)) if isinstance(node, ast.ImportFrom) and not node.level]
    return {name.name for node in froms for name in node.names}
