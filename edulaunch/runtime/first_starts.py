"""Programs whose first start fails, as on a computer with too many processes. A launch file cannot read which starts the rubric
has chosen.
"""

from __future__ import annotations

from collections.abc import Sequence


class FirstStarts:
    """The part of a host that refuses starts.

    :ivar fails: the programs whose first start fails, by executable, or as the first words of a command.
    """

    fails: Sequence[str] = ()

    def refused_now(self, name: str) -> str | None:
        """Return the item of `fails` for a program that may not start now, or None if the program may start."""
        return next((each for each in self.fails if f'{name} '.startswith(f'{each} ')), None)

    def refuses(self, name: str) -> bool:
        """Return whether this start of a program fails. The next start of the same program does not fail."""
        refused = self.refused_now(name)
        if refused is not None:
            self.fails = [each for each in self.fails if each != refused]
        return refused is not None
