"""What an exercise asks for: which runs, and which checks over them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from random import Random

from .check import Check
from .scenario import Scenario


class Rubric:
    """The scenarios and checks of one exercise.

    :param title: the exercise in a few words.
    :param scenarios: makes the runs from a random generator, which is seeded from the submission: so the
        values of a run change with every edit and cannot be written into the file beforehand.
    :param checks: in the order of the report; each stands behind the checks it needs: there can be no circle.
    :raises ValueError: two checks of one name, or a check before one that it needs.
    """

    def __init__(self, *, title: str, scenarios: Callable[[Random], Sequence[Scenario]], checks: Sequence[Check]) -> None:
        self.title = title
        self.checks = tuple(checks)
        self._scenarios = scenarios
        _refuse_disorder(self.checks)

    def scenarios(self, seed: int) -> tuple[Scenario, ...]:
        """The runs for this seed: the same seed gives the same runs."""
        return tuple(self._scenarios(Random(seed)))


def _refuse_disorder(checks: Sequence[Check]) -> None:
    known: dict[str, Check] = {}
    for check in checks:
        if check.name in known:
            raise ValueError(f'two checks are called {check.name}')
        for need in check.needs:
            if known.get(need.name) is not need:
                raise ValueError(f'{check.name} needs {need.name}, which is not before it in the rubric')
        known[check.name] = check
