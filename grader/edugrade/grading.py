"""Grades submissions: runs the scenarios of their rubrics, judges what happened. The command and the notebook share it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, NamedTuple

from .catalogue import find_rubric
from .limits import Limits
from .runner import Runner, Ticket
from .submission import Submission

if TYPE_CHECKING:
    from .results import Report
    from .rubric import Rubric


class Work(NamedTuple):
    """A submission with what it is graded by."""

    submission: Submission
    name: str
    rubric: Rubric
    seed: int


def plan_work(submission: Submission, rubric: str | None = None, seed: int | None = None) -> Work:
    """Find the rubric and choose the seed of a submission.

    :param rubric: a rubric's name or file, instead of the one that the submission's name says.
    :param seed: chooses the values of the runs; default: the content of the submission.
    :raises UnusableInput: when there is no such rubric.
    """
    name, found = find_rubric(submission.exercise, rubric)
    return Work(submission, name, found, submission.seed if seed is None else seed)


def grade(
    work: Sequence[Work],
    limits: Limits | None = None,
    workspaces: Sequence[str] = (),
    on_outcome: Callable[[], object] | None = None,
    processors: int | None = None,
) -> Iterator[Report]:
    """The report of each piece of work, in order, as soon as it is ready.

    :param workspaces: folders with the student's packages, besides those that are found.
    :param on_outcome: called after each run.
    :param processors: how many runs go at once; default: as many as there are processors.
    """
    with Runner(limits, on_outcome, processors) as runner:
        tickets = [runner.add(item.submission, item.rubric.scenarios(item.seed), workspaces) for item in work]
        from . import judging, results  # noqa: F401  (loaded while the first runs are under way)

        tickets.reverse()
        for item in work:
            yield _report(item, runner, tickets.pop())  # nothing is kept of it here: recordings are large


def _report(work: Work, runner: Runner, ticket: Ticket) -> Report:
    from .judging import judge
    from .results import Report

    outcomes = runner.wait(ticket)
    submission = work.submission
    return Report(
        file=submission.file,
        given=submission.given,
        folder=submission.folder,
        shown=submission.shown_folder,
        package=submission.package.name if submission.package else None,
        sha256=submission.sha256,
        rubric=work.name,
        title=work.rubric.title,
        seed=work.seed,
        outcomes=tuple(outcomes),
        results=tuple(judge(work.rubric.checks, outcomes, submission.source)),
        gaps=tuple(submission.source.gaps),
    )
