"""Where something was written: a file and a line."""

from __future__ import annotations

from typing import NamedTuple


class Origin(NamedTuple):
    """The place in a student's file that made a launch action or a parameter."""

    file: str
    line: int

    def __str__(self) -> str:
        return f'{self.file}:{self.line}'
