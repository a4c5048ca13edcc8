"""A place in a file."""

from __future__ import annotations

from typing import NamedTuple


class Place(NamedTuple):
    """A file and, where it is known, a line of it (counted from 1)."""

    file: str
    line: int | None = None
