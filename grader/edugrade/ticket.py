"""What is asked of a runner for one submission."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from .outcome import Outcome
from .scenario import Scenario


class Ticket:
    """The runs of one submission: what is asked for, and what has come of it."""

    def __init__(self, scenarios: Sequence[Scenario]) -> None:
        self.scenarios = list(scenarios)
        self.outcomes: dict[str, Outcome] = {}
        self.again: Counter[str] = Counter()  # how often a run was begun again, by the scenario's name

    @property
    def is_done(self) -> bool:
        """Whether every run has ended."""
        return len(self.outcomes) == len(self.scenarios)
