"""Applies a rubric's checks to what the runs came to."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType
from typing import Any

from .causes import with_causes
from .check import Check
from .cpu_limit import TooLong, cpu_limit
from .evidence import Evidence
from .failure import Failure
from .outcome import Outcome
from .results import FAILED, GRADER_BROKE, NOT_RUN, PASSED, CheckResult
from .source import Source
from .verdicts import REPORT_IT

LONGEST_CHECK_S = 5.0  # usual: a thousandth of it
LAUNCHES = 'launches'
LAUNCHES_SENTENCE = 'The launch file can be launched and runs to the end'


def judge(
    checks: Sequence[Check], outcomes: Sequence[Outcome], source: Source, names: Mapping[str, Any] = MappingProxyType({})
) -> list[CheckResult]:
    """The result of each check in the rubric's order, after the one all need: that there is a recording.

    A check runs when all it needs has passed. Without a recording none does: nothing passes without evidence.
    """
    results = {LAUNCHES: _launches(outcomes, source)}
    scenarios = {outcome.scenario.name: outcome.scenario for outcome in outcomes}
    recordings = {outcome.scenario.name: outcome.recording for outcome in outcomes if outcome.recording}
    evidence = Evidence(scenarios, recordings, source, names)
    for check in checks:
        blocker = _blocker(check, results)
        result = _result(check, evidence) if blocker is None else _not_run(check, blocker, results)
        results[check.name] = result
    return with_causes(list(results.values()), evidence)


def _launches(outcomes: Sequence[Outcome], source: Source) -> CheckResult:
    """The result that the outcomes themselves give; a fault of the grader goes before one of the student."""
    for kind, status in (('broke', GRADER_BROKE), ('unusable', FAILED), ('stopped', FAILED)):
        bad = [outcome for outcome in outcomes if outcome.kind == kind]
        if bad:
            return CheckResult(
                LAUNCHES,
                LAUNCHES_SENTENCE,
                status,
                reason=bad[0].text,
                seen=_which(bad, outcomes),
                where=bad[0].where or source.place,
                try_=bad[0].try_,
            )
    return CheckResult(LAUNCHES, LAUNCHES_SENTENCE, PASSED)


def too_much(checks: Sequence[Check], why: str, source: Source) -> list[CheckResult]:
    """The results of a submission whose runs could not be judged within the limits of a worker."""
    first = _unseen(CheckResult(LAUNCHES, LAUNCHES_SENTENCE, FAILED), why, source)
    return [first, *(_not_run(check, first, {LAUNCHES: first}) for check in checks)]


def _unseen(result: CheckResult, why: str, source: Source) -> CheckResult:
    return replace(
        result,
        reason=f'the run left so much behind that it cannot be looked at: {why}',
        where=source.place,
        try_='look for a node that publishes without pause, or for very many nodes',
    )


def broken(error: Exception) -> CheckResult:
    """The only result of a submission on which the grader itself broke."""
    reason = f'the grader broke on it: {type(error).__name__}: {error}'
    return CheckResult(LAUNCHES, LAUNCHES_SENTENCE, GRADER_BROKE, reason=reason, try_=REPORT_IT)


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
    verb = 'broke' if root.status == GRADER_BROKE else 'failed'
    return replace(_plain(check, NOT_RUN), root_cause=root.name, reason=f'because "{root.sentence}" {verb}')


def _result(check: Check, evidence: Evidence) -> CheckResult:
    try:
        with cpu_limit(LONGEST_CHECK_S):
            check(evidence)
    except TooLong as error:
        return _unseen(_plain(check, FAILED), str(error), evidence.source)
    except MemoryError:
        return _unseen(_plain(check, FAILED), 'memory has run out', evidence.source)
    except Failure as failure:
        return replace(
            _plain(check, FAILED),
            reason=failure.rationale,
            expected=failure.expected,
            seen=failure.seen,
            where=failure.where,
            try_=failure.try_,
            share=failure.share,
            steps=failure.steps,
        )
    except Exception as error:  # whatever a check raises that is no Failure is a fault of the grader
        return replace(_plain(check, GRADER_BROKE), reason=_words(error, check), try_=REPORT_IT)
    return _plain(check, PASSED)


def _plain(check: Check, status: str) -> CheckResult:
    needs = tuple(need.name for need in check.needs)
    return CheckResult(check.name, check.sentence, status, check.points, needs)


def _words(error: Exception, check: Check) -> str:
    """Type, text and place of an unexpected exception, without a traceback: the line of the rubric, else where it was raised."""
    places = []
    trace = error.__traceback__
    while trace is not None:
        places.append((trace.tb_frame.f_code.co_filename, trace.tb_lineno))
        trace = trace.tb_next
    rubric = getattr(getattr(check.function, '__code__', None), 'co_filename', None)
    file, line = next((place for place in reversed(places) if place[0] == rubric), places[-1])
    return f'the check itself broke: {type(error).__name__}: {error} ({file}:{line})'
