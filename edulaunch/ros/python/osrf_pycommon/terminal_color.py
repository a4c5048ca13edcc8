"""Removes the colours of terminals from strings."""

from __future__ import annotations

import re

_ESCAPE = re.compile(r'\x1b(?:\[[0-?]*[ -/]*[@-~]|[@-Z\\-_])')


def remove_ansi_escape_sequences(string: str) -> str:
    """Return the string without the sequences that set colours or move the cursor of a terminal."""
    return _ESCAPE.sub('', string)
