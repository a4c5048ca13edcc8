"""The result of grading a submission, as data. The modules that write reports read only these data."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

from .evidence import Outcome
from .source import Gap, Place

if TYPE_CHECKING:
    from edulaunch.advice import Finding

    from .variant import Variant

PASSED, FAILED, NOT_RUN, GRADER_BROKE = ('passed', 'failed', 'not_run', 'grader_broke')

ALL_PASSED, SOME_FAILED, UNUSABLE_INPUT, BROKEN_GRADER = range(4)  # exit codes
VERDICTS = ('all passed', 'some failed', 'unusable input', 'grader broke')

LAUNCHES, REPEATS, OWN_VARIANT = OF_NO_RUBRIC = ('launches', 'repeats', 'own_variant')
"""Checks of every submission: it runs, it runs the same way again, and it is the student's own."""


def rounded(points: float) -> float:
    """Round points to at most two decimals, and return an integer where possible."""
    points = round(points, 2)
    return int(points) if points == int(points) else points


@dataclass(frozen=True)
class CheckResult:
    """The result of one check.

    :param name: the name of the check's function.
    :param sentence: the sentence that the student reads.
    :param status: PASSED, FAILED, NOT_RUN or GRADER_BROKE.
    :param points: the points of the check, which a passed check earns.
    :param needs: the names of the checks that this check needs.
    :param reason: one sentence that explains why the check failed, why it was not run, or how the grader broke.
    :param expected: what the check expected, or None.
    :param seen: what the check found instead, or None.
    :param where: the place to change, or None.
    :param try_: what to do, or None.
    :param root_cause: the name of the check to correct first, for a check that was not run, or None.
    :param cause: the finding of edulaunch's rules that explains the failure, or None.
    :param share: the share of the points that a failed check still earns.
    :param steps: the earlier steps of the advice, before `try_`, if the rubric has any.
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
        """The earned points: all points of a passed check, or the share that a failed check still earns.

        The value is an integer where possible.
        """
        return rounded(self.points * (1.0 if self.status == PASSED else self.share))


@dataclass(frozen=True)
class Report:
    """The report on a graded submission.

    :param file: the absolute path of the launch file.
    :param given: the path that the caller used.
    :param folder: the absolute path of the submission's directory.
    :param shown: the string that replaces `folder` in reports.
    :param package: the name of the package, or None for a launch file that is not in a package.
    :param secret: the name of the course secret that determined the seed, or None.
    :param student: the name of the student, or ''.
    :param level: the level of the advice that readers see. The data always contain all advice.
    :param is_counted: whether the attempt is in the student's progress file, so that later attempts get more specific advice.
    :param word: a message to the student, for example that the file has not changed or that progress cannot be saved.
    :param why: the reason why the exercise matters on a robot, for a submission that passes all checks.
    :param variant: the values of a personalised exercise, or None.
    :param looked: the digest of each run and the launch graph for `reports.document`, or None if they are not known.
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
    is_counted: bool = False
    word: str = ''
    why: str = ''
    variant: Variant | None = None
    looked: tuple[list[str | None], list[str]] | None = None

    @property
    def sandbox(self) -> dict[str, str]:
        """For each layer of the sandbox 'held', or the reason why it failed in one of the runs. The dict is empty without a
        sandbox.
        """
        found: dict[str, str] = {}
        for outcome in self.outcomes:
            for layer, state in (outcome.sandbox or {}).items():
                found[layer] = state if found.get(layer, 'held') == 'held' else found[layer]
        return found

    @property
    def has_run(self) -> bool:
        """Whether code of the submission has run."""
        return any(outcome.sandbox is not None for outcome in self.outcomes)

    @property
    def refused(self) -> tuple[str, ...]:
        """The names of the forbidden system calls that recorded runs tried to make. Other runs name them in their own
        messages.
        """
        return tuple(sorted({name for outcome in self.outcomes if outcome.kind == 'recorded' for name in outcome.refused}))

    @property
    def passed(self) -> int:
        """The number of passed checks."""
        return sum(result.status == PASSED for result in self.results)

    @property
    def verdict(self) -> str:
        """The outcome in words."""
        return VERDICTS[self.exit_code]

    @property
    def possible(self) -> int:
        """The sum of the points of all checks."""
        return sum(result.points for result in self.results)

    @property
    def earned(self) -> float | None:
        """The earned points, or None if the grader broke, because then there is no mark."""
        return None if self.exit_code == BROKEN_GRADER else rounded(sum(result.earned for result in self.results))

    @property
    def exit_code(self) -> int:
        """The exit code: 0 if all checks passed, 1 if some failed, 2 if the launch file cannot be run, 3 if the grader broke."""
        statuses = {result.status for result in self.results}
        if GRADER_BROKE in statuses:
            return BROKEN_GRADER
        if any(outcome.kind == 'unusable' for outcome in self.outcomes):
            return UNUSABLE_INPUT
        return ALL_PASSED if statuses == {PASSED} else SOME_FAILED


class Refusal(NamedTuple):
    """A path that could not be graded: the given path, the reason, the advice, and the exit code."""

    given: str
    reason: str
    help: str | None = None
    exit_code: int = UNUSABLE_INPUT
