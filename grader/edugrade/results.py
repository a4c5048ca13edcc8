"""What grading a submission came to, as data. The renderers read this and nothing else."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

from .evidence import Outcome
from .source import Gap, Place

if TYPE_CHECKING:
    from edulaunch.advice import Finding

    from .variant import Variant

PASSED, FAILED, NOT_RUN, GRADER_BROKE = STATUSES = ('passed', 'failed', 'not_run', 'grader_broke')

ALL_PASSED, SOME_FAILED, UNUSABLE_INPUT, BROKEN_GRADER = range(4)  # exit codes
VERDICTS = ('all passed', 'some failed', 'unusable input', 'grader broke')

LAUNCHES, REPEATS, OWN_VARIANT = OF_NO_RUBRIC = ('launches', 'repeats', 'own_variant')
"""Checks that no rubric has: whether it runs at all, as it did before, and is the student's own."""


def rounded(points: float) -> float:
    """Points as people write them: two decimals at most, and none where none are needed."""
    points = round(points, 2)
    return int(points) if points == int(points) else points


@dataclass(frozen=True)
class CheckResult:
    """One check's verdict.

    :param name: of the check's function; :param sentence: what the student reads.
    :param status: one of STATUSES; the four are never merged.
    :param points: what the check is worth; it is earned only when passed.
    :param reason: one sentence: why it failed, why it was not run, how the grader broke.
    :param cause: what the rules of edulaunch find behind it.
    :param root_cause: name of the check to repair first, for a check that was not run.
    :param share: of the points, that a failed check gives for what is right.
    :param steps: what is advised before `try_`, when the rubric says it.
    """

    name: str
    sentence: str
    status: str
    points: int = 0
    needs: tuple[str, ...] = ()
    reason: str = ''
    expected: str | None = None
    seen: str | None = None
    where: Place | None = None
    try_: str | None = None
    root_cause: str | None = None
    cause: Finding | None = None
    share: float = 0.0
    steps: tuple[str, ...] = ()

    @property
    def earned(self) -> float:
        """The points given: all of them, or of a failed check the share that the check grants. Whole where they can be."""
        return rounded(self.points * (1.0 if self.status == PASSED else self.share))


@dataclass(frozen=True)
class Report:
    """A graded submission.

    :param file: the launch file, absolute; `given` is how the caller named the submission.
    :param folder: the submission's folder, absolute, and how it is `shown`: '' or with a separator at its end.
    :param package: the name of the package that it is, if it is one.
    :param secret: names the course secret that chose the seed, if one did.
    :param student: whose it is; '' where nobody asked.
    :param level: how much of the advice people see, see `steps`; data has all of it.
    :param variant: the values of the student's own exercise, if it has any.
    :param why: why it matters on a robot, said when all is passed.
    :param word: what the student must be told besides: that the file is unchanged, that progress cannot be kept.
    """

    file: str
    given: str
    folder: str
    shown: str
    package: str | None
    sha256: str
    rubric: str
    title: str
    seed: int
    outcomes: tuple[Outcome, ...]
    results: tuple[CheckResult, ...]
    gaps: tuple[Gap, ...] = ()
    rubric_sha256: str = ''
    secret: str | None = None
    student: str = ''
    level: int = 3
    word: str = ''
    why: str = ''
    variant: Variant | None = None

    @property
    def sandbox(self) -> dict[str, str]:
        """For each layer of confinement 'held', or why it did not hold in one of the runs; {} when none was asked for."""
        found: dict[str, str] = {}
        for outcome in self.outcomes:
            for layer, state in outcome.sandbox.items():
                found[layer] = state if found.get(layer, 'held') == 'held' else found[layer]
        return found

    @property
    def refused(self) -> tuple[str, ...]:
        """Names of the system calls that its recorded runs tried and may not make. (The text of another run has its own.)"""
        return tuple(sorted({name for outcome in self.outcomes if outcome.kind == 'recorded' for name in outcome.refused}))

    @property
    def passed(self) -> int:
        """How many checks passed."""
        return sum(result.status == PASSED for result in self.results)

    @property
    def verdict(self) -> str:
        """What it came to, in words."""
        return VERDICTS[self.exit_code]

    @property
    def possible(self) -> int:
        """All points of the rubric."""
        return sum(result.points for result in self.results)

    @property
    def earned(self) -> float | None:
        """Points given; None when the grader broke, because then there is no mark."""
        return None if self.exit_code == BROKEN_GRADER else rounded(sum(result.earned for result in self.results))

    @property
    def exit_code(self) -> int:
        """0 all passed, 1 some failed, 2 the launch file cannot be run at all, 3 the grader broke."""
        statuses = {result.status for result in self.results}
        if GRADER_BROKE in statuses:
            return BROKEN_GRADER
        if any(outcome.kind == 'unusable' for outcome in self.outcomes):
            return UNUSABLE_INPUT
        return ALL_PASSED if statuses == {PASSED} else SOME_FAILED


class Refusal(NamedTuple):
    """A path that could not be graded at all: how it was given, why, what to try, and what the command ends with for it."""

    given: str
    reason: str
    help: str | None = None
    exit_code: int = UNUSABLE_INPUT
