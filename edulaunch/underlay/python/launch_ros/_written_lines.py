"""Where a Python launch file writes the keys of a call's dictionaries."""

from __future__ import annotations

import re

# A text (with the colon behind it when it is a key), a comment, a bracket.
_TOKEN = re.compile(
    r'(?P<text>[rbuRBU]{0,2}(?:'
    r'''"{3}(?:\\.|(?!"{3}).)*"{3}|\'{3}(?:\\.|(?!\'{3}).)*\'{3}|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'))'''  # noqa: Q001
    r"""(?P<colon>\s*:)?|\#[^\n]*|(?P<open>[(\[{])|(?P<close>[)\]}])""",
    re.DOTALL,
)
LONGEST_CALL = 400
"""Lines; what stands farther below the beginning of a call is not looked at."""


def key_lines(file: str, line: int) -> dict[str, int]:
    """Text of each dictionary key in the call that begins on `line`, with the line it stands on (the last one,
    when it is written more than once); empty when the file cannot be read.
    """
    import linecache

    lines = linecache.getlines(file)[line - 1 : line - 1 + LONGEST_CALL]
    found: dict[str, int] = {}
    depth = 0
    text = ''.join(lines)
    counted, number = 0, line
    for token in _TOKEN.finditer(text):
        if token['open']:
            depth += 1
        elif token['close']:
            depth -= 1
            if depth <= 0:
                break
        elif token['colon'] and depth:
            number += text.count('\n', counted, token.start())
            counted = token.start()
            found[token['text'].lstrip('rbuRBU').strip('"\'')] = number
    return found
