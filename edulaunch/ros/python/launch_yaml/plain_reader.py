"""Reads the simple YAML of most launch files line by line.

libyaml creates ten objects for each word. Many files do not need them: they contain only block mappings and lists, plain words,
numbers, short quoted strings and one-line `{name: x, value: 1}` mappings. Reading 1000 nodes takes 42 ms, and 195 ms with
libyaml. Reading and visiting them must take less than 120 ms. Both readers must always return
equal results, so libyaml reads every file that may contain anything else.
"""

from __future__ import annotations

import re
from functools import lru_cache
from typing import Any

from launch.utilities._yaml_values import YAML_BOOLEANS
from launch.utilities.yaml_reader import Mapping

MAX_DEPTH = 40
"""The maximum depth of nested values. libyaml reads files with deeper ones."""

_CHARACTERS = re.compile(r'[ -~\n]*')
_SPECIAL = frozenset(('true', 'false', 'yes', 'no', 'on', 'off', 'y', 'n', 'null'))
_KEY = r'[A-Za-z_][A-Za-z0-9_-]*'
_KEY_ALONE = re.compile(_KEY)
_LINE = re.compile(rf'^( *)((?:- )*)(?:({_KEY}):(?: (\S.*))?|(\S.*))?$', re.MULTILINE)
# A string that begins like a word, has no colon, comment or special character of YAML, and does not end with a space.
_TEXT = re.compile(r'[A-Za-z_/$][A-Za-z0-9_/$().+-]*(?: [A-Za-z0-9_/$().+-]+)*')
_QUOTED = re.compile(r'"[^"\\]*"|\'[^\']*\'')
_INTEGER = re.compile(r'-?(?:0|[1-9][0-9]*)')
_DECIMAL = re.compile(r'-?[0-9]+\.[0-9]+')
_PAIR = rf'{_KEY}: (?:[A-Za-z0-9_/$().+-]+(?: [A-Za-z0-9_/$().+-]+)*|"[^"\\]*"|\'[^\']*\')'
_FLOW = re.compile(rf'\{{({_PAIR}(?:, {_PAIR})*)\}}')
_FLOW_PAIR = re.compile(rf'({_KEY}): ("[^"\\]*"|\'[^\']*\'|[^,]+)')

_Row = tuple[int, str | None, str, int]
"""A row has the column, the key, the value's text and the line. The dash of a list has the key None, and a value alone has the
key ''. The text may be ''.
"""


class NotPlain(Exception):
    """The text is not simple, so libyaml must read it."""


def read_plain(text: str) -> Any:
    """Return the data of the text, as `yaml.safe_load` returns them; dicts are :class:`Mapping`.

    :raises NotPlain: when the text is not simple. It may still be valid YAML.
    """
    if _CHARACTERS.fullmatch(text) is None:
        raise NotPlain
    rows = _rows(text)
    if not rows or rows[0][0] != 0:
        raise NotPlain
    value, end = _block(rows, 0, 0)
    if end != len(rows) - 1:
        raise NotPlain
    return value


def _rows(text: str) -> list[_Row]:
    rows: list[_Row] = []
    for number, (spaces, dashes, key, value, alone) in enumerate(_LINE.findall(text), 1):
        column = len(spaces)
        if not dashes:
            if not key and (not alone or alone[0] == '#'):
                continue
        elif key or alone:
            for _ in range(0, len(dashes), 2):
                rows.append((column, None, '', number))
                column += 2
        else:
            raise NotPlain
        rows.append((column, key, value or alone, number))
    if rows:
        rows.append((-1, '', '', 0))
    return rows


def _block(rows: list[_Row], start: int, depth: int) -> tuple[Any, int]:
    """Return the value that begins in a row, and the number of the row after the value."""
    if depth > MAX_DEPTH:
        raise NotPlain
    column, key, text, _ = rows[start]
    if key is None:
        return _list(rows, start, column, depth)
    if key:
        return _mapping(rows, start, column, depth)
    if not text or rows[start + 1][0] > column:
        raise NotPlain
    return _value(text, rows[start][3]), start + 1


def _list(rows: list[_Row], start: int, column: int, depth: int) -> tuple[list[Any], int]:
    items: list[Any] = []
    while rows[start][0] == column and rows[start][1] is None:
        inside, key, text, line = rows[start + 1]
        if key == '' and text and rows[start + 2][0] <= inside:
            items.append(_value(text, line))
            start += 2
        else:
            item, start = _block(rows, start + 1, depth + 1)
            items.append(item)
    if rows[start][0] > column:
        raise NotPlain
    return items, start


def _mapping(rows: list[_Row], start: int, column: int, depth: int) -> tuple[Mapping, int]:
    mapping = Mapping()
    mapping.line = rows[start][3]
    while True:
        here, key, text, line = rows[start]
        if here != column or not key:
            break
        start += 1
        if key.lower() in _SPECIAL:
            raise NotPlain
        if text:
            if rows[start][0] > column:
                raise NotPlain
            mapping[key] = _scalar(text) if text[0] != '{' else _value(text, line)
        else:
            below = rows[start]
            if below[0] < column or (below[0] == column and below[1] is not None):
                raise NotPlain
            mapping[key], start = _block(rows, start, depth + 1)
    if here > column or (here == column and key == ''):
        raise NotPlain
    return mapping, start


def _value(text: str, line: int) -> Any:
    if text[0] != '{':
        return _scalar(text)
    if '"' in text or "'" in text:
        return _quoted_flow(text, line)
    if text[-1] != '}':
        raise NotPlain
    mapping = Mapping()
    mapping.line = line
    for pair in text[1:-1].split(', '):
        key, _, value = pair.partition(': ')
        if not value or not _is_flow_key(key):
            raise NotPlain
        mapping[key] = _scalar(value)
    return mapping


def _quoted_flow(text: str, line: int) -> Mapping:
    """Read a one-line mapping in which a comma may also be inside quotation marks."""
    found = _FLOW.fullmatch(text)
    if found is None:
        raise NotPlain
    mapping = Mapping()
    mapping.line = line
    for key, value in _FLOW_PAIR.findall(found[1]):
        if not _is_flow_key(key):
            raise NotPlain
        mapping[key] = _scalar(value)
    return mapping


@lru_cache(maxsize=1024)
def _is_flow_key(key: str) -> bool:
    return _KEY_ALONE.fullmatch(key) is not None and key.lower() not in _SPECIAL


@lru_cache(maxsize=4096)
def _scalar(text: str) -> Any:
    if _TEXT.fullmatch(text):
        if text.lower() not in _SPECIAL:
            return text
        if text in YAML_BOOLEANS:
            return YAML_BOOLEANS[text]
    elif _INTEGER.fullmatch(text):
        return int(text)
    elif _QUOTED.fullmatch(text):
        return text[1:-1]
    elif _DECIMAL.fullmatch(text):
        return float(text)
    raise NotPlain
