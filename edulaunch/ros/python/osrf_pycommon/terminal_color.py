"""Colours of terminals: the sequences that set them, and strings without these sequences."""

from __future__ import annotations

import re

_ESCAPE = re.compile(r'\x1b(?:\[[0-?]*[ -/]*[@-~]|[@-Z\\-_])')
_STYLES = ['reset', 'boldon', 'italicson', 'ulon', 'invon', 'boldoff', 'italicsoff', 'uloff', 'invoff']
_CODES = dict(zip(_STYLES, (0, 1, 3, 4, 7, 22, 23, 24, 27), strict=True))
_COLOURS = enumerate(('black', 'red', 'green', 'yellow', 'blue', 'purple', 'cyan', 'white'))
_CODES |= {f'{colour}{end}': first + number for number, colour in _COLOURS for end, first in (('', 30), ('f', 30), ('b', 40))}


def ansi(key: str) -> str:
    """Return the sequence that a terminal reads as this colour or style.

    :param key: a name such as 'red', 'redf' (the same), 'redb' for the background, 'boldon' or 'reset'.
    :raises KeyError: if the name is unknown.
    """
    return f'\x1b[{_CODES[key]}m'


def remove_ansi_escape_sequences(string: str) -> str:
    """Return the string without the sequences that set colours or move the cursor of a terminal."""
    return _ESCAPE.sub('', string)
