"""Grades submissions: runs the scenarios of their rubrics and judges the recordings. The command and the notebook use this
module.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from time import process_time
from typing import TYPE_CHECKING, Any, NamedTuple

from .bare_runs import Again, Plan, keeps_all, plan_of, with_defaults_given
from .job import CAN_FORK, GradingJob, Limits
from .rubrics.catalogue import find_rubric
from .submission import Submission, exercise_of
from .variant import Variant, variant_for
from .worker import Exceeded, in_worker

if TYPE_CHECKING:
    from .evidence import Outcome, Scenario
    from .in_place import InPlace
    from .results import CheckResult, Report
    from .rubric import Rubric
    from .runner import Runner
    from .variant import CourseSecret


FEW = 8
"""For more submissions than this, the starter loads more before the first run."""


class Work(NamedTuple):
    """A submission with its rubric and seed.

    `secret` is the name of the course secret that determined the seed, or None. `variant` contains the values of the
    student's own exercise, or None.
    """

    submission: Submission
    name: str
    rubric: Rubric
    seed: int
    secret: str | None = None
    variant: Variant | None = None

    @property
    def sha256(self) -> str:
        """The SHA-256 digest of the submission's text."""
        return self.submission.sha256

    @property
    def rubric_sha256(self) -> str:
        """The SHA-256 digest of the rubric's text."""
        return self.rubric.sha256

    @property
    def scenarios(self) -> tuple[Scenario, ...]:
        """The scenarios that the rubric creates for the seed."""
        return self.rubric.scenarios(self.seed)


def plan_work(
    submission: Submission,
    rubric: str | None = None,
    seed: int | None = None,
    secret: CourseSecret | None = None,
    student: str = '',
    only: str | None = None,
    variant: Variant | None = None,
    called: str = '',
) -> Work:
    """Find the rubric and the seed of a submission, and return them as work.

    :param rubric: the name or the file of a rubric that replaces the rubric with the submission's name.
    :param seed: the number that determines the values of the runs (default: computed from the secret and the student, or from
        the submission's content).
    :param secret: the secret of the course, or None.
    :param student: the student whose seed the secret determines.
    :param only: the name of the only check to run, together with the checks that it needs.
    :param variant: the values of the student's own exercise (default: from the secret or the student's copy of the course).
    :param called: the name of the student who has a personal exercise, or '' if all students have the same exercise.
    :raises UnusableInput: if the rubric does not exist or does not have this check.
    """
    name = exercise_of(os.path.basename(rubric)) if rubric else submission.exercise
    variant = variant or variant_for(name, called, secret if called else None)
    name, found = find_rubric(submission.exercise, rubric, submission.folder, variant.of if variant else None)
    found = found if only is None else found.part(only)
    if seed is None and secret is not None:
        return Work(submission, name, found, secret.seed(name, student, submission.sha256), secret.name, variant)
    return Work(submission, name, found, submission.seed if seed is None else seed, variant=variant)


def grade(
    work: Sequence[Work],
    limits: Limits | None = None,
    workspaces: Sequence[str] = (),
    on_outcome: Callable[[], object] | None = None,
    processors: int | None = None,
    for_documents: bool = False,
) -> Iterator[Report]:
    """Yield the report of each piece of work, in order, as soon as the report is ready.

    :param limits: the limits of each run (default: the usual limits).
    :param workspaces: additional directories with the student's packages.
    :param on_outcome: called after each run.
    :param processors: the number of parallel runs (default: the number of processors).
    :param for_documents: whether the worker that judges also computes the data for `reports.document`.
    """
    with runner_here(limits, on_outcome, processors, len(work) > FEW) as runner:
        jobs = [runner.add(item.submission, item.scenarios, workspaces) for item in work]
        _load_during_the_first_runs()
        jobs.reverse()
        for item in work:
            yield _report(item, runner, jobs.pop(), workspaces, for_documents)  # not stored here, because recordings are large


def _load_during_the_first_runs() -> None:
    """Load the modules for judging. The grader waits now; later, each run would wait for these modules."""
    import edulaunch.engine.recording.recorded_types
    import edulaunch.runtime.link.provenance  # noqa: F401

    from . import judging, repeated, results  # noqa: F401


class WarmGrader:
    """A grader that grades submissions one after the other with one runner, whose starter has loaded the engine. `close` ends it.

    :param limits: the limits of each run.
    """

    def __init__(self, limits: Limits | None = None) -> None:
        self._runner = runner_here(limits, is_for_many=True)
        self._runner.__enter__()

    def report(self, work: Work, workspaces: Sequence[str] = ()) -> Report:
        """Grade a piece of work, and return the report."""
        job = self._runner.add(work.submission, work.scenarios, workspaces)
        return _report(work, self._runner, job, workspaces, for_documents=True)

    def close(self) -> None:
        """End the runner and its starter."""
        self._runner.__exit__(None, None, None)


def runner_here(
    limits: Limits | None = None,
    on_outcome: Callable[[], object] | None = None,
    processors: int | None = None,
    is_for_many: bool = False,
) -> Runner | InPlace:
    """Return the runner for this system.

    The runner uses a confined process for each run or, on a system without fork, this process.
    """
    if CAN_FORK:
        from .runner import Runner

        return Runner(limits, on_outcome, processors, is_for_many)
    from .in_place import InPlace

    return InPlace(limits, on_outcome)


def _report(work: Work, runner: Runner | InPlace, job: GradingJob, workspaces: Sequence[str], for_documents: bool) -> Report:
    from .judging import broken, no_mark, too_much
    from .results import FAILED, Report

    def again(scenarios: Sequence[Scenario]) -> list[Outcome]:
        return runner.wait(runner.add(work.submission, scenarios, workspaces, is_next=True))

    outcomes, looked = runner.wait(job), None
    submission = work.submission
    try:
        outcomes, results, looked = _judged(work, outcomes, again, for_documents)
        results[1:1] = [*_other_variant(work), *_repeated(work, outcomes, again)]
    except Exceeded as error:
        fault = runner.fault()
        results = [no_mark(fault)] if fault else too_much(work.rubric.checks, str(error), submission.source)
    except Exception as error:  # a fault of the grader with one submission must not affect the others
        results = [broken(error)]
    if any(result.status == FAILED for result in results) and not submission.is_as_it_was():
        results = [no_mark(f'{submission.given} could be read before the runs, and now it is another text or cannot be read')]
    return Report(
        **submission.named,
        sha256=submission.sha256,
        rubric=work.name,
        title=work.rubric.title,
        seed=work.seed,
        outcomes=tuple(outcomes),
        results=tuple(results),
        gaps=tuple(submission.source.gaps),
        rubric_sha256=work.rubric_sha256,
        secret=work.secret,
        variant=work.variant,
        looked=looked,
    )


MOST_CPU_BEFORE_LOOKS_S = 3.0
"""After so much processor time, a worker that judges leaves the digests to another one."""


def _judged(
    work: Work, outcomes: list[Outcome], again: Again, for_documents: bool
) -> tuple[list[Outcome], list[CheckResult], tuple[list[str | None], list[str]] | None]:
    """Return the outcomes (with the repeated runs that defaults need), the results, and the data for documents or None.

    One worker does everything if no run must be repeated, because a fork and the copies after it take 8 ms.
    """
    from .judging import judge, judged, result_of, rows_of

    def judge_here() -> list[CheckResult]:
        return judge(work.rubric.checks, outcomes, work.submission.source)

    def look() -> tuple[Plan, list[dict[str, Any]] | None, Any]:
        began_s, plan = process_time(), _plan_of(outcomes)  # a worker may be this process, which had other work before
        if not keeps_all(plan):
            return plan, None, None
        rows = rows_of(judge_here)
        is_slow = process_time() - began_s > MOST_CPU_BEFORE_LOOKS_S
        return plan, rows, _looks(outcomes) if for_documents and not is_slow else None

    plan, rows, looked = in_worker(look)
    if rows is None:
        outcomes = with_defaults_given(outcomes, again, plan)
        return outcomes, judged(judge_here), None
    return outcomes, [result_of(row) for row in rows], looked


def _plan_of(outcomes: Sequence[Outcome]) -> Plan:
    if not any(outcome.scenario.defaults for outcome in outcomes):
        return []
    try:
        return plan_of(outcomes)
    except MemoryError:
        raise
    except Exception:  # judging meets the same error, and reports it
        return []


def _looks(outcomes: Sequence[Outcome]) -> tuple[list[str | None], list[str]] | None:
    from .reports.document import look_at

    try:
        return look_at(outcomes)
    except MemoryError:  # the judgement must not be lost with it
        return None


COPIED = "this is another student's variant, which gets no mark until a teacher has looked at it"


def is_copied(work: Work) -> bool:
    """Return whether a file of the submission contains the values of another student's variant."""
    return work.variant is not None and any(map(work.variant.is_of_another, work.submission.source.texts().values()))


def _other_variant(work: Work) -> list[CheckResult]:
    """Return the result of a submission that is based on another student's exercise, or an empty list for other submissions.

    Such a submission gets no mark, because a teacher must decide.
    """
    from .results import GRADER_BROKE, OWN_VARIANT, CheckResult

    if work.variant is None or not is_copied(work):
        return []
    return [
        CheckResult(
            OWN_VARIANT,
            'The file is made from your own starter file',
            GRADER_BROKE,
            reason=COPIED,
            expected=f'Variant {work.variant.tag}, made for {work.variant.student}',
            where=work.submission.source.place,
            try_='start from your own starter file, which has your names and numbers',
        )
    ]


def _repeated(work: Work, outcomes: Sequence[Outcome], run: Again) -> list[CheckResult]:
    """Run the scenarios with the student's own nodes again. Return a result that reports differences between the runs.

    Return no result if no second run finished because the computer was busy or the grader failed.
    """
    from .judging import judged
    from .repeated import difference, has_own_programs, result

    own = [outcome for outcome in outcomes if outcome.recording is not None and has_own_programs(outcome.recording)]
    if not own:
        return []
    again = run([outcome.scenario for outcome in own])
    pairs = [(one, two) for one, two in zip(own, again, strict=True) if not two.may_be_unfinished_by_chance]
    if not pairs:
        return []
    return judged(lambda: [result([(one.scenario, difference(one, two)) for one, two in pairs], work.submission.source)])


WIDTH = 40


@contextmanager
def progress_bar(total: int) -> Iterator[Callable[[], None]]:
    """Provide a function to call after each of `total` runs. The bar appears on standard error and disappears at the end."""
    if total == 0 or not sys.stderr.isatty():
        yield lambda: None
        return
    done = 0

    def show() -> None:
        filled = WIDTH * done // total
        sys.stderr.write(f'\r\x1b[Krunning the launch files [{"#" * filled}{"-" * (WIDTH - filled)}] {done}/{total}')
        sys.stderr.flush()

    def advance() -> None:
        nonlocal done
        done = min(done + 1, total)  # a repeated run has already been counted
        show()

    show()
    try:
        yield advance
    finally:
        sys.stderr.write('\r\x1b[K')
        sys.stderr.flush()
