"""Shortens strings for reports, and turns regular expressions into readable lines."""

from __future__ import annotations

import re
from collections.abc import Sequence

_SIGNS = (
    (re.compile(r'\(\?[:=!]|[()^$]'), ''),
    (re.compile(r'-\?'), ''),
    (re.compile(r'\\[bBAZ]'), ''),
    (re.compile(r'(?:(?:\\d|\[0-9\]|\[\\d\.\])(?:[+*?]|\{\d+(?:,\d*)?\})?(?:\\\.)?)+'), 'NUMBER'),
    (re.compile(r'(?:\\[wS]|\[[^\]\s]+\])(?:[+*?]|\{\d+(?:,\d*)?\})?'), 'WORD'),
    (re.compile(r'(?:\.|\\s)[+*]\??'), ' ... '),
    (re.compile(r'(?<=\w)\|(?=\w)'), ' or '),
    (re.compile(r'\\(.)'), r'\1'),
)


def shortened(text: str, most: int) -> str:
    """Return at most `most` characters of a string, up to the end of a word. If the first word is longer, it is cut."""
    if len(text) <= most:
        return text
    start = text[:most]
    end = max(start.rfind(' '), start.rfind('\n'))
    return start[:end] if end > 0 else start


def last_lines(texts: Sequence[str], lines: int = 4, most: int = 300) -> str:
    """Return the last lines of a program's output, each with at most `most` characters. Return '' without output."""
    found = [line for line in ''.join(texts).splitlines() if line.strip()]
    return '\n'.join(line if len(line) <= most else f'{shortened(line, most)} ...' for line in found[-lines:])


def readable(pattern: str) -> str:
    """Return an example of a line that a regular expression matches. Words replace the patterns of the expression, such as
    ``messages: NUMBER``.
    """
    for sign, word in _SIGNS:
        pattern = sign.sub(word, pattern)
    return pattern.strip()
