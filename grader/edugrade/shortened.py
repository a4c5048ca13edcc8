"""Shorter texts for reports: never cut in the middle of a word, and no regular expression is shown to a student."""

from __future__ import annotations

import re
from collections.abc import Sequence

_SIGNS = (
    (re.compile(r'\(\?[:=!]|[()^$]'), ''),
    (re.compile(r'-\?'), ''),
    (re.compile(r'(?:\\d[+*]?(?:\\\.)?)+'), 'NUMBER'),
    (re.compile(r'\\[wS][+*]?'), 'WORD'),
    (re.compile(r'(?:\.|\\s)[+*]\??'), ' ... '),
    (re.compile(r'\\(.)'), r'\1'),
)


def shortened(text: str, most: int) -> str:
    """Return the beginning of a text, of `most` characters at most, up to the end of a word; a longer word is cut."""
    if len(text) <= most:
        return text
    start = text[:most]
    end = max(start.rfind(' '), start.rfind('\n'))
    return start[:end] if end > 0 else start


def last_lines(texts: Sequence[str], lines: int = 4, most: int = 300) -> str:
    """Return the last lines of what a program wrote, each of `most` characters at most; '' when it wrote nothing."""
    found = [line for line in ''.join(texts).splitlines() if line.strip()]
    return '\n'.join(line if len(line) <= most else f'{shortened(line, most)} ...' for line in found[-lines:])


def readable(pattern: str) -> str:
    """Return what a regular expression asks for, as text that a person reads: ``messages: NUMBER``."""
    for sign, word in _SIGNS:
        pattern = sign.sub(word, pattern)
    return pattern.strip()
