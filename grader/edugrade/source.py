"""The submission as text: for pointing at lines, never for marks."""

from __future__ import annotations

import re

from .place import Place

_GAP = re.compile(r'\s*#\s*TODO\b')
_FUNCTION = re.compile(r'\s*(async\s+)?def\s+generate_launch_description\b')
_LIST = re.compile(r'.*\bLaunchDescription\s*\(')


class Source:
    """The lines of a submission."""

    def __init__(self, file: str, text: str) -> None:
        self.file = file
        self._lines = text.splitlines()

    @property
    def place(self) -> Place:
        """Where a missing action belongs: the line of ``LaunchDescription(``, else of the function."""
        return Place(
            self.file, self._line_of(_LIST, after=self._line_of(_FUNCTION) or 0) or self._line_of(_FUNCTION)
        )

    @property
    def gaps(self) -> list[tuple[int, str]]:
        """(line, text) of the comments that mark what is still to be written."""
        return [(number, line.strip()) for number, line in enumerate(self._lines, 1) if _GAP.match(line)]

    def _line_of(self, pattern: re.Pattern[str], after: int = 0) -> int | None:
        for number, line in enumerate(self._lines, 1):
            if number >= after and pattern.match(line):
                return number
        return None
