"""Entries as a tree of lines."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from typing import Any

from edulaunch.plan.explanation import Entry

TWIGS = ('├── ', '└── ', '│   ', '    ')
ASCII_TWIGS = ('|-- ', '`-- ', '|   ', '    ')
STYLES = {
    'node': 'bold green',
    'process': 'bold green',
    'include': 'bold cyan',
    'parameter': '',
    'event': 'magenta',
    'timer': 'magenta',
    'event_handler': 'magenta',
    'argument': 'yellow',
    'missing': 'red',
}
SIGNS = {'+': 'green', '-': 'red', '~': 'yellow'}


def place_of(entry: Entry) -> str:
    """'file:line' as far as the text does not say it already; '' when there is none."""
    if entry['file'] is None or (entry['kind'] == 'parameter' and 'origin' in entry):
        return ''
    return f'{os.path.basename(entry["file"])}:{entry["line"]}'


def text_of(entry: Entry) -> str:
    """The line of an entry, with the sign of a difference before it, and what it was before the change."""
    sign, text = entry.get('sign', '').strip(), entry['text']
    if sign == '~':
        text += f'  was {_other_words(entry["before"], text)}'
    return f'{sign} {text}' if sign else text


def _other_words(before: str, after: str) -> str:
    """`before` without the words that both begin with."""
    old, new = before.split(' '), after.split(' ')
    same = next((number for number, words in enumerate(zip(old, new, strict=False)) if words[0] != words[1]), len(new))
    rest = ' '.join(old[same:])
    return rest[:-1] if '[' in before and '[' not in rest else rest


def drawn(entries: Sequence[Entry], twigs: Sequence[str] = TWIGS, indent: str = '') -> Iterator[str]:
    """The tree with its branches drawn, for where there is no colour."""
    through, last, beside, nothing = twigs
    for number, entry in enumerate(entries, 1):
        is_last = number == len(entries)
        place = place_of(entry)
        yield f'{indent}{last if is_last else through}{text_of(entry)}' + (f'  <{place}>' if place else '')
        yield from drawn(entry['children'], twigs, indent + (nothing if is_last else beside))


def print_in_colour(title: str, entries: Sequence[Entry]) -> None:
    """The same for a terminal; long lines go on below their own beginning."""
    from rich.console import Console
    from rich.text import Text
    from rich.tree import Tree

    def grow(tree: Any, below: Sequence[Entry]) -> None:
        for entry in below:
            style = SIGNS.get(entry.get('sign', ''), STYLES.get(entry['kind'], 'dim'))
            label = Text(text_of(entry), style=style if entry['is_taken'] else 'dim strike')
            place = place_of(entry)
            if place:
                label.append(f'  <{place}>', style='dim')
            grow(tree.add(label), entry['children'])

    root = Tree(Text(title, style='bold'), guide_style='dim')
    grow(root, entries)
    Console(highlight=False).print(root)
