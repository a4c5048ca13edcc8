"""What grading a submission came to, as data. The renderers read this and nothing else."""

from __future__ import annotations

from dataclasses import dataclass

from .outcome import Outcome
from .place import Place

PASSED, FAILED, NOT_RUN, GRADER_BROKE = STATUSES = ('passed', 'failed', 'not_run', 'grader_broke')

ALL_PASSED, SOME_FAILED, UNUSABLE_INPUT, BROKEN_GRADER = range(4)  # exit codes


@dataclass(frozen=True)
class CheckResult:
    """One check's verdict.

    :param name: of the check's function; :param sentence: what the student reads.
    :param status: one of STATUSES; the four are never merged.
    :param points: what the check is worth; it is earned only when passed.
    :param reason: one sentence: why it failed, why it was not run, how the grader broke.
    :param root_cause: name of the check to repair first, for a check that was not run.
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

    @property
    def earned(self) -> int:
        """The points given."""
        return self.points if self.status == PASSED else 0


@dataclass(frozen=True)
class Report:
    """A graded submission. `file` is absolute; `given` is how the caller named it."""

    file: str
    given: str
    sha256: str
    rubric: str
    title: str
    seed: int
    outcomes: tuple[Outcome, ...]
    results: tuple[CheckResult, ...]
    gaps: tuple[tuple[int, str], ...] = ()

    @property
    def possible(self) -> int:
        """All points of the rubric."""
        return sum(result.points for result in self.results)

    @property
    def earned(self) -> int | None:
        """Points given; None when the grader broke, because then there is no mark."""
        return None if self.exit_code == BROKEN_GRADER else sum(result.earned for result in self.results)

    @property
    def exit_code(self) -> int:
        """0 all passed, 1 some failed, 2 the launch file cannot be run at all, 3 the grader broke."""
        statuses = {result.status for result in self.results}
        if GRADER_BROKE in statuses:
            return BROKEN_GRADER
        if any(outcome.kind == 'unusable' for outcome in self.outcomes):
            return UNUSABLE_INPUT
        return ALL_PASSED if statuses == {PASSED} else SOME_FAILED
