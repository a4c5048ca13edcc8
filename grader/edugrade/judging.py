"""Applies a rubric's checks to what the runs came to."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from .check import Check
from .evidence import Evidence
from .failure import Failure
from .outcome import Outcome
from .results import FAILED, GRADER_BROKE, NOT_RUN, PASSED, CheckResult
from .source import Source
from .verdicts import REPORT_IT

LAUNCHES = 'launches'
LAUNCHES_SENTENCE = 'The launch file can be launched and runs to the end'


def judge(checks: Sequence[Check], outcomes: Sequence[Outcome], source: Source) -> list[CheckResult]:
    """The result of each check in the rubric's order, after the one all need: that there is a recording.

    A check runs when all it needs has passed. Without a recording none does: nothing passes without evidence.
    """
    results = {LAUNCHES: _launches(outcomes, source)}
    recordings = {
        outcome.scenario.name: outcome.recording for outcome in outcomes if outcome.recording is not None
    }
    evidence = Evidence({outcome.scenario.name: outcome.scenario for outcome in outcomes}, recordings, source)
    for check in checks:
        blocker = _blocker(check, results)
        results[check.name] = (
            _result(check, evidence) if blocker is None else _not_run(check, blocker, results)
        )
    return list(results.values())


def _launches(outcomes: Sequence[Outcome], source: Source) -> CheckResult:
    """The result that the outcomes themselves give; a fault of the grader goes before one of the student."""
    for kind, status in (('broke', GRADER_BROKE), ('unusable', FAILED), ('stopped', FAILED)):
        bad = [outcome for outcome in outcomes if outcome.kind == kind]
        if bad:
            first = bad[0]
            return CheckResult(
                LAUNCHES,
                LAUNCHES_SENTENCE,
                status,
                reason=first.text,
                try_=first.try_,
                seen=_which(bad, outcomes),
                where=first.where,
            )
    return CheckResult(LAUNCHES, LAUNCHES_SENTENCE, PASSED)


def _which(bad: Sequence[Outcome], outcomes: Sequence[Outcome]) -> str | None:
    """Which launches went wrong, when not all of them did."""
    if len(bad) == len(outcomes):
        return None
    return 'only when launched with ' + ' and with '.join(outcome.scenario.words for outcome in bad)


def _blocker(check: Check, results: Mapping[str, CheckResult]) -> CheckResult | None:
    for name in (LAUNCHES, *(need.name for need in check.needs)):
        if results[name].status != PASSED:
            return results[name]
    return None


def _not_run(check: Check, blocker: CheckResult, results: Mapping[str, CheckResult]) -> CheckResult:
    root = results[blocker.root_cause] if blocker.root_cause is not None else blocker
    return CheckResult(
        check.name,
        check.sentence,
        NOT_RUN,
        check.points,
        _names(check),
        root_cause=root.name,
        reason=f'because "{root.sentence}" {"broke" if root.status == GRADER_BROKE else "failed"}',
    )


def _result(check: Check, evidence: Evidence) -> CheckResult:
    try:
        check(evidence)
    except Failure as failure:
        return CheckResult(
            check.name,
            check.sentence,
            FAILED,
            check.points,
            _names(check),
            failure.rationale,
            failure.expected,
            failure.seen,
            failure.where,
            failure.try_,
        )
    except Exception as error:  # whatever a check raises that is no Failure is a fault of the grader
        return CheckResult(
            check.name,
            check.sentence,
            GRADER_BROKE,
            check.points,
            _names(check),
            reason=_words(error),
            try_=REPORT_IT,
        )
    return CheckResult(check.name, check.sentence, PASSED, check.points, _names(check))


def _names(check: Check) -> tuple[str, ...]:
    return tuple(need.name for need in check.needs)


def _words(error: Exception) -> str:
    """Type, text and place of an unexpected exception, without a traceback."""
    trace = error.__traceback__
    while trace is not None and trace.tb_next is not None:
        trace = trace.tb_next
    place = '' if trace is None else f' ({trace.tb_frame.f_code.co_filename}:{trace.tb_lineno})'
    return f'the check itself broke: {type(error).__name__}: {error}{place}'
