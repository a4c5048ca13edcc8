"""Fingerprints of code that do not change with names, comments, spaces, texts and numbers (winnowing, Schleimer et al. 2003)."""

from __future__ import annotations

import keyword
import re
from collections.abc import Sequence
from typing import NamedTuple
from zlib import crc32

TOKENS, WINDOW = 9, 4  # tokens in a fingerprint, fingerprints of which the smallest is kept
MOST_TOKENS = 50_000
# Texts and comments are measured: what never ends must not be looked through again and again.
_TOKEN = re.compile(
    r'(?P<skip>\s+|#[^\n]*|<!--.{0,2000}?-->)'
    r'|(?P<text>(?:\b[rRbBfFuU]{1,2})?(?:"""(?:[^\\]|\\.){0,5000}?"""|\'\'\'(?:[^\\]|\\.){0,5000}?\'\'\'|"(?:[^"\\\n]|\\.){0,300}"|\'(?:[^\'\\\n]|\\.){0,300}\'))'
    r'|(?P<number>\d[\w.]*)|(?P<name>[^\W\d]\w*)|(?P<sign>.)',
    re.S,
)
_IMPORT = re.compile(r'^\s*(?:from\s+[\w.]+\s+)?import\s+([^\n#]+)', re.M)


class Code(NamedTuple):
    """The lines of a text, and the lines on which each of its fingerprints begins and ends."""

    lines: list[str]
    prints: dict[int, tuple[int, int]]


def fingerprints(text: str) -> Code:
    """The fingerprints of Python, XML or YAML. Names that are imported, attributes and words of Python stay what they are."""
    tokens = _tokens(text)
    grams = [
        (
            crc32(' '.join(word for word, _ in tokens[start : start + TOKENS]).encode()),
            tokens[start][1],
            tokens[start + TOKENS - 1][1],
        )
        for start in range(len(tokens) - TOKENS + 1)
    ]
    kept: dict[int, tuple[int, int]] = {}
    for start in range(max(1, len(grams) - WINDOW + 1) if grams else 0):
        number, first, last = min(grams[start : start + WINDOW])
        kept.setdefault(number, (first, last))
    return Code(text.splitlines(), kept)


def _tokens(text: str) -> Sequence[tuple[str, int]]:
    """(normalised token, its line) for each token."""
    known = {
        name.strip() for found in _IMPORT.findall(text) for part in found.split(',') for name in part.strip('() ').split(' as ')
    }
    found: list[tuple[str, int]] = []
    line, before = 1, ''
    for match in _TOKEN.finditer(text):
        word, kind = match[0], match.lastgroup
        if kind != 'skip' and len(found) < MOST_TOKENS:
            if kind == 'name' and not (keyword.iskeyword(word) or word in known or before == '.'):
                found.append(('n', line))
            else:
                found.append(({'text': 's', 'number': '0'}.get(kind or '', word), line))
            before = word
        line += word.count('\n')
    return found
