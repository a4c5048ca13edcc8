"""Write entries as a tree: as lines of text, with colours in a terminal, or as HTML in which entries open and close."""

from __future__ import annotations

import os
import shutil
import textwrap
from collections.abc import Callable, Iterator, Sequence
from html import escape

from edulaunch.advice.plan.explanation import Entry

TWIGS = ('├── ', '└── ', '│   ', '    ')
ASCII_TWIGS = ('|-- ', '`-- ', '|   ', '    ')
STYLES = {
    'node': '1;32',
    'process': '1;32',
    'include': '1;36',
    'parameter': '0',
    'event': '35',
    'timer': '35',
    'event_handler': '35',
    'argument': '33',
    'missing': '31',
}
SIGNS = {'+': '36', '-': '33', '~': '1'}
BOLD, DIM, NOT_TAKEN = '1', '2', '2;9'
"""The numbers of the styles in a terminal."""
STYLE = """<style>
.edulaunch-tree{font-family:monospace;line-height:1.5;overflow-wrap:anywhere}
.edulaunch-tree details,.edulaunch-tree .leaf{margin-left:1.3em}
.edulaunch-tree summary{cursor:pointer;margin-left:-1.1em}
.edulaunch-tree small{opacity:.7}
.edulaunch-tree .node,.edulaunch-tree .process,.edulaunch-tree .include{font-weight:bold}
.edulaunch-tree .left-out{opacity:.6;text-decoration:line-through}
.edulaunch-tree .added{border-left:.3em solid #3b7ddd;padding-left:.3em}
.edulaunch-tree .gone{border-left:.3em dashed #b8741a;padding-left:.3em}
.edulaunch-tree .changed{border-left:.3em double #808080;padding-left:.3em}
</style>"""
_CLASSES = {'+': ' added', '-': ' gone', '~': ' changed'}
_CLOSED = frozenset(('node', 'process', 'composable_node'))
"""Kinds of entries that are closed in a large tree, so that the reader first sees the nodes."""
LARGE = 60


def place_of(entry: Entry) -> str:
    """Return the place of an entry as 'file:line', or an empty string if the text of the entry already contains it."""
    if entry['file'] is None or (entry['kind'] == 'parameter' and 'origin' in entry):
        return ''
    created = f' (created at line {entry["created_line"]})' if 'created_line' in entry else ''
    return f'{os.path.basename(entry["file"])}:{entry["line"]}{created}'


def text_of(entry: Entry) -> str:
    """Return the text of an entry. For a difference, add the sign before it and the old text after it."""
    sign, text = entry.get('sign', '').strip(), entry['text']
    if sign == '~':
        text += f'  was {_other_words(entry["before"], text)}'
    return f'{sign} {text}' if sign else text


def _other_words(before: str, after: str) -> str:
    """Return `before` without the words at its beginning that `after` also has."""
    old, new = before.split(' '), after.split(' ')
    same = next((number for number, words in enumerate(zip(old, new, strict=False)) if words[0] != words[1]), len(new))
    rest = ' '.join(old[same:])
    return rest[:-1] if '[' in before and '[' not in rest else rest


def label_of(entry: Entry) -> str:
    """Return the text of an entry, followed by its place."""
    place = place_of(entry)
    return text_of(entry) + (f'  <{place}>' if place else '')


def _plain(entry: Entry, branch: str, below: str) -> Iterator[str]:
    yield branch + label_of(entry)


def drawn(
    entries: Sequence[Entry],
    twigs: Sequence[str] = TWIGS,
    indent: str = '',
    shown: Callable[[Entry, str, str], Iterator[str]] = _plain,
) -> Iterator[str]:
    """Yield the lines of a tree.

    :param entries: the entries of the tree.
    :param twigs: the four strings with which branches are drawn.
    :param indent: the beginning of each line.
    :param shown: a function that yields the lines of an entry, from the entry, its branch, and the beginning of its further
        lines.
    """
    through, last, beside, nothing = twigs
    for number, entry in enumerate(entries, 1):
        is_last = number == len(entries)
        below = indent + (nothing if is_last else beside)
        yield from shown(entry, indent + (last if is_last else through), below)
        yield from drawn(entry['children'], twigs, below, shown)


def print_in_colour(title: str, entries: Sequence[Entry], twigs: Sequence[str] = TWIGS) -> None:
    """Print a tree in a terminal, and wrap long lines. Use colours unless NO_COLOR is set."""
    is_coloured = not os.environ.get('NO_COLOR') and os.environ.get('TERM') != 'dumb'
    width = shutil.get_terminal_size().columns

    def paint(style: str, text: str) -> str:
        return f'\x1b[{style}m{text}\x1b[0m' if is_coloured and text else text

    def shown(entry: Entry, branch: str, below: str) -> Iterator[str]:
        style = SIGNS.get(entry.get('sign', ''), STYLES.get(entry['kind'], DIM)) if entry['is_taken'] else NOT_TAKEN
        place = f'<{place_of(entry)}>'
        for line in textwrap.wrap(label_of(entry), max(width - len(branch), 8), break_on_hyphens=False) or ['']:
            text = line.removesuffix(place)
            yield paint(DIM, branch) + paint(style, text) + paint(DIM, line[len(text) :])
            branch = below

    print('\n'.join((paint(BOLD, title), *drawn(entries, twigs, shown=shown))))


def html_tree(title: str, entries: Sequence[Entry]) -> str:
    """Return the tree as HTML. Every line is escaped, because a launch file chooses the names in it."""
    opens = _count(entries) <= LARGE
    inside = ''.join(_html(entry, opens) for entry in entries)
    label = escape(f'explanation of {title}', quote=True)
    return f'{STYLE}<div class="edulaunch-tree" role="group" aria-label="{label}"><b>{escape(title)}</b>{inside}</div>'


def _count(entries: Sequence[Entry]) -> int:
    return len(entries) + sum(_count(entry['children']) for entry in entries)


def _html(entry: Entry, opens: bool) -> str:
    place = place_of(entry)
    words = escape(text_of(entry)) + (f' <small>{escape(place)}</small>' if place else '')
    classes = entry['kind'].lower().replace('_', '-') + _CLASSES.get(entry.get('sign', ''), '')
    classes += '' if entry['is_taken'] else ' left-out'
    line = f'<span class="{escape(classes, quote=True)}">{words}</span>'
    if not entry['children']:
        return f'<div class="leaf">{line}</div>'
    state = ' open' if opens or entry['kind'] not in _CLOSED else ''
    below = ''.join(_html(child, opens) for child in entry['children'])
    return f'<details{state}><summary>{line}</summary>{below}</details>'
