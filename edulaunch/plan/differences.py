"""What differs between two explanations: a tree with only the entries that are added, gone or changed, and what they stand in."""

from __future__ import annotations

from collections.abc import Iterator
from difflib import SequenceMatcher
from typing import Any

from edulaunch.plan.explanation import Entry

ADDED, GONE, CHANGED, SAME = '+', '-', '~', ' '


def differences(before: Entry, after: Entry) -> list[Entry]:
    """The entries of `tree` that differ, each with a `sign`: '+', '-', '~' (its text changed; `before` has the old one), or
    ' ' when only something below it did. Places do not count: another line is no difference."""
    return _differing(before['tree'], after['tree'])


def _differing(before: list[Entry], after: list[Entry]) -> list[Entry]:
    old, new = [_identity(entry) for entry in before], [_identity(entry) for entry in after]
    found: list[Entry] = []
    for what, start, end, new_start, new_end in SequenceMatcher(None, old, new, autojunk=False).get_opcodes():
        if what == 'equal':
            for one, other in zip(before[start:end], after[new_start:new_end], strict=True):
                found += _compared(one, other)
            continue
        found += [_whole(entry, GONE) for entry in before[start:end]]
        found += [_whole(entry, ADDED) for entry in after[new_start:new_end]]
    return found


def _identity(entry: Entry) -> tuple[Any, ...]:
    """What makes two entries the same thing, perhaps with another value."""
    kind = entry['kind']
    if kind in ('argument', 'parameter', 'set_configuration', 'set_parameter'):
        return kind, entry['text'].partition(' = ')[0]
    if kind == 'node':
        return kind, entry['name'], entry['package'], entry['executable']
    if kind in ('timer', 'log', 'output', 'set_env', 'environment', 'push_namespace'):
        return (kind,)
    if 'condition' in entry:
        return 'condition', entry['condition'], entry['file'], entry['line']
    return kind, entry['text']


def _compared(before: Entry, after: Entry) -> Iterator[Entry]:
    below = _differing(before['children'], after['children'])
    if before['text'] != after['text']:
        yield {**after, 'sign': CHANGED, 'before': before['text'], 'children': below}
    elif below:
        yield {**after, 'sign': SAME, 'children': below}


def _whole(entry: Entry, sign: str) -> Entry:
    return {**entry, 'sign': sign, 'children': [_whole(child, sign) for child in entry['children']]}
