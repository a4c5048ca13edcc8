"""What a check is: a function over the recorded runs, with points and with the checks it needs."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

from .evidence import Evidence

CheckFunction = Callable[[Evidence], None]


class Check(NamedTuple):
    """One check of a rubric. Call it with the evidence: it returns when it passes, else raises Failure.

    :param name: the function's name; stable, used in the JSON report.
    :param sentence: what is checked, as the student reads it.
    :param points: given when the check passes.
    :param needs: checks that must have passed before this one says anything of use.
    """

    name: str
    sentence: str
    function: CheckFunction
    points: int = 0
    needs: tuple[Check, ...] = ()

    def __call__(self, run: Evidence) -> None:
        self.function(run)


def check(*, points: int = 0, needs: Sequence[Check] = ()) -> Callable[[CheckFunction], Check]:
    """Make a check of a function; the first line of its docstring is the sentence that the student sees.

    :raises ValueError: the function has no docstring, or the points are negative.
    """

    def make(function: CheckFunction) -> Check:
        name = getattr(function, '__name__', 'check')
        text = (function.__doc__ or '').strip()
        if not text:
            raise ValueError(f'the check {name}() has no docstring; its first line is the sentence the student reads')
        if not isinstance(points, int) or points < 0:
            raise ValueError(f'the check {name}() has {points!r} points; points are whole numbers, and never negative')
        if not all(isinstance(need, Check) for need in needs):
            raise ValueError(f'the check {name}() needs {needs!r}; what it needs are checks, not their names')
        return Check(name, text.splitlines()[0].strip(), function, points, tuple(needs))

    return make
