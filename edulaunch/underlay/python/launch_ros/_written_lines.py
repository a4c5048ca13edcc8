"""Where a Python launch file writes the keys of a call's dictionaries."""

from __future__ import annotations

import re

# A text (with the colon behind it when it is a key; what stands before its quote is not looked at), a comment, a bracket.
_TOKEN = re.compile(
    r"""(?P<text>"{3}(?:\\.|(?!"{3}).)*"{3}|\'{3}(?:\\.|(?!\'{3}).)*\'{3}|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\')"""  # noqa: Q001
    r"""(?P<colon>\s*:)?|\#[^\n]*|(?P<open>[(\[{])|(?P<close>[)\]}])""",
    re.DOTALL,
)
LONGEST_CALL = 400
"""Lines; what stands farther below the beginning of a call is not looked at."""
SHORT_CALL = 12
"""Lines; nearly all calls end here, and to read farther for each takes longer than to launch it."""


def key_lines(file: str, line: int) -> dict[str, int]:
    """Text of each dictionary key in the call that begins on `line`, with the line it stands on (the last one,
    when it is written more than once); empty when the file cannot be read.
    """
    import linecache

    lines = linecache.getlines(file)[line - 1 : line - 1 + LONGEST_CALL]
    beginning = ''.join(lines[:SHORT_CALL])
    if len(lines) > SHORT_CALL and '"""' not in beginning and "'''" not in beginning:
        found, is_closed = _keys_in(beginning, line)
        if is_closed:
            return found
    return _keys_in(''.join(lines), line)[0]


def _keys_in(text: str, line: int) -> tuple[dict[str, int], bool]:
    """The keys, and whether the call ends in the text, which begins on `line`."""
    found: dict[str, int] = {}
    depth = 0
    counted, number = 0, line
    for token in _TOKEN.finditer(text):
        kind = token.lastgroup
        if kind == 'open':
            depth += 1
        elif kind == 'close':
            depth -= 1
            if depth <= 0:
                return found, True
        elif kind == 'colon' and depth:
            number += text.count('\n', counted, token.start())
            counted = token.start()
            found[token['text'].strip('"\'')] = number
    return found, False
