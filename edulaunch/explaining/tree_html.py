"""Entries as a tree that opens and closes, for notebooks and pages: details and summary, without any script."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

from edulaunch.explaining.tree_text import place_of, text_of
from edulaunch.plan.explanation import Entry

STYLE = """<style>
.edulaunch-tree{font-family:monospace;line-height:1.5;overflow-wrap:anywhere}
.edulaunch-tree details,.edulaunch-tree .leaf{margin-left:1.3em}
.edulaunch-tree summary{cursor:pointer;margin-left:-1.1em}
.edulaunch-tree small{opacity:.7}
.edulaunch-tree .node,.edulaunch-tree .process,.edulaunch-tree .include{font-weight:bold}
.edulaunch-tree .left-out{opacity:.6;text-decoration:line-through}
.edulaunch-tree .added{border-left:.3em solid #2a9d4a;padding-left:.3em}
.edulaunch-tree .gone{border-left:.3em solid #c0392b;padding-left:.3em}
.edulaunch-tree .changed{border-left:.3em solid #c98a00;padding-left:.3em}
</style>"""
_CLASSES = {'+': ' added', '-': ' gone', '~': ' changed'}
_CLOSED = frozenset(('node', 'process', 'composable_node'))
"""What is shown closed in a large tree: one sees first which nodes there are."""
LARGE = 60


def html_tree(title: str, entries: Sequence[Entry]) -> str:
    """The tree as HTML; every line is escaped, for names come from a launch file."""
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
