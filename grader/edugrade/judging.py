"""Applies a rubric's checks to what the runs came to, in a worker, and gives failures their likely cause.

The causes are what the rules of `edulaunch.advice` find in the runs.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import asdict, replace
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from .evidence import Evidence, Failure, Missing, Outcome
from .faults import REPORT_IT, words_of
from .results import FAILED, GRADER_BROKE, LAUNCHES, NOT_RUN, PASSED, CheckResult
from .rubric import Check
from .source import Place, Source
from .worker import TooLong, cpu_limit, in_worker

if TYPE_CHECKING:
    from edulaunch.advice.rule import Finding

LONGEST_CHECK_S = 5.0  # usual: a thousandth of it
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
    bags = {outcome.scenario.name: outcome.bags for outcome in outcomes}
    bare = {outcome.scenario.name: outcome.bare for outcome in outcomes if outcome.bare}
    evidence = Evidence(scenarios, recordings, source, names, bags, bare)
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
    reason, try_ = words_of(error)
    return no_mark(reason, try_)


def no_mark(reason: str, try_: str = 'look who changes files there, and grade it again') -> CheckResult:
    """The only result of a submission that got no mark because of what is not the student's."""
    return CheckResult(LAUNCHES, LAUNCHES_SENTENCE, GRADER_BROKE, reason=reason, try_=try_)


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
        if isinstance(failure, Missing):
            failure.ask(evidence.source.texts().values())
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


def judged(judge: Callable[[], Sequence[CheckResult]]) -> list[CheckResult]:
    """What `judge` comes to in a worker; the one result that says so when the grader broke in it.

    :raises Exceeded, Lost: as `in_worker`.
    """
    return [_of_row(row) for row in in_worker(lambda: _rows(judge))]


def _rows(judge: Callable[[], Sequence[CheckResult]]) -> list[dict[str, Any]]:
    try:
        results = judge()
    except MemoryError:
        raise  # the worker has an answer for it
    except Exception as error:
        results = [broken(error)]
    return [asdict(result) for result in results]


def _of_row(row: dict[str, Any]) -> CheckResult:
    row['needs'] = tuple(row['needs'])
    row['steps'] = tuple(row['steps'])
    row['where'] = Place(*row['where']) if row['where'] else None
    if row['cause']:
        from edulaunch.advice.rule import Finding  # a submission that passes has no cause, and need not wait for the rules

        row['cause'] = Finding(*row['cause'])
    return CheckResult(**row)


LONGEST_S = 2.0  # usual: a hundredth of it
COVERED_BY_CHECKS = ('launch.unknown-argument', 'programs.died', 'programs.interrupted', 'programs.rule-failed')
"""Rubrics tell of dead programs and missing arguments themselves; the arguments of a run are the grader's."""
SHORTEST_NAME = 4
"""Letters of a name that may be looked for in a text."""


def with_causes(results: list[CheckResult], evidence: Evidence) -> list[CheckResult]:
    """The results, each failed one with the finding that is about the same thing or place. When no finding is about any of them,
    the one of the most points (it looks at what happened) has the worst. No finding is told twice; marks do not depend on it.
    """
    if not evidence or all(result.status != FAILED for result in results):
        return results
    findings = _findings(evidence, any(' died ' in (result.reason or '') for result in results))
    kept: list[CheckResult] = []
    for result in results:
        cause = next((finding for finding in findings if _is_about(finding, result)), None) if result.status == FAILED else None
        if cause is not None:
            findings.remove(cause)
            result = replace(result, cause=cause)
        kept.append(result)
    return kept if any(result.cause for result in kept) else _with_worst(kept, findings)


def _findings(evidence: Evidence, death_is_covered: bool) -> list[Finding]:
    """Of all runs, the worst first; none when there is so much that it takes too long."""
    from edulaunch.advice.judging import in_order

    try:
        with cpu_limit(LONGEST_S):
            found = in_order([finding for recording in evidence.values() for finding in recording.advice])
    except MemoryError:
        raise
    except Exception:  # a rule that breaks costs the causes, and never the mark
        return []
    covered = COVERED_BY_CHECKS if death_is_covered else tuple(rule for rule in COVERED_BY_CHECKS if rule != 'programs.died')
    return [finding for finding in found if finding.rule not in covered]


def _is_about(finding: Finding, result: CheckResult) -> bool:
    if result.where is not None and finding.file is not None and tuple(result.where) == (finding.file, finding.line):
        return True
    texts = ' '.join(filter(None, (result.sentence, result.reason, result.expected, result.seen)))
    return any(re.search(rf'(?<![\w/]){re.escape(name)}(?![\w/])', texts) for name in _names(finding))


def _names(finding: Finding) -> Iterator[str]:
    for name in (finding.name, finding.name.strip('/'), finding.facts.get('near')):
        if isinstance(name, str) and len(name) >= SHORTEST_NAME:
            yield name


def _with_worst(results: Sequence[CheckResult], findings: Sequence[Finding]) -> list[CheckResult]:
    from edulaunch.advice.rule import rule_named

    worst = next((finding for finding in findings if rule_named(finding.rule).level == 'error'), None)
    weightiest = max((result for result in results if result.status == FAILED), key=lambda result: result.points)
    return [replace(result, cause=worst) if result is weightiest else result for result in results]
