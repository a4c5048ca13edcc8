"""Read notebook cells that write a file. Such a cell begins with a line such as `%%writefile follow.launch.py`."""

from __future__ import annotations

import re

_FIRST = re.compile(r'%%(?:writefile|file)\s+(?:-a\s+)?(?P<name>[^\n]+?)\s*(?:\n|$)')


def written_file(cell: str) -> tuple[str, str] | None:
    """Return the name of the file that a cell writes, and its content with as many lines as the cell. Return None for other
    cells.

    The magic line becomes a comment or an empty line, so that line numbers stay the same.
    """
    match = _FIRST.match(cell)
    if match is None:
        return None
    name = match['name'].strip('\'"')
    return name, '\n' + cell[match.end() :] if match.end() > len(match[0].rstrip('\n')) else ''
