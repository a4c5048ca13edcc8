"""One mistake, and how it is shown."""

from __future__ import annotations

import os
from typing import NamedTuple


class Mistake(NamedTuple):
    """What is wrong at a place. `line` counts from 1, 0 means the file as a whole; `help` says what to do."""

    file: str
    line: int
    sentence: str
    help: str | None = None

    def text(self, base: str) -> str:
        """For people, with the file relative to `base`."""
        inside = self.file == base or self.file.startswith(base + os.sep)
        place = os.path.relpath(self.file, base) if inside else self.file
        told = f'{place}:{self.line}: {self.sentence}' if self.line else f'{place}: {self.sentence}'
        return told if self.help is None else f'{told}\n  help: {self.help}'
