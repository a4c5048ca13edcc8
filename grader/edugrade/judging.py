"""Applies the checks of a rubric to the outcomes of the runs, and adds the likely cause to failed checks.

The causes are findings of the rules of `edulaunch.advice` in the runs.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, replace
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from .evidence import Evidence, Failure, Outcome
from .faults import REPORT_IT, words_of
from .library.deaths import words_on_deaths
from .library.launched import VISITOR
from .results import FAILED, GRADER_BROKE, LAUNCHES, NOT_RUN, PASSED, CheckResult
from .rubric import Check
from .source import Place, SubmittedText, is_shipped
from .worker import TooLong, cpu_limit, in_worker

if TYPE_CHECKING:
    from edulaunch.advice.rule import Finding

LONGEST_CHECK_S = 5.0  # a check usually takes a thousandth of this
LAUNCHES_SENTENCE = 'The launch file starts and runs to the end without an error'


def judge(
    checks: Sequence[Check], outcomes: Sequence[Outcome], source: SubmittedText, names: Mapping[str, Any] = MappingProxyType({})
) -> list[CheckResult]:
    """Return the result of each check in the rubric's order. The first result states whether the launch file runs.

    A check runs if all checks that it needs have passed. Without a recording, no check runs and no check passes. A failure that
    another failed check explains has the status of a check that did not run, and as few points.
    """
    results = {LAUNCHES: _launches(outcomes, source)}
    scenarios = {outcome.scenario.name: outcome.scenario for outcome in outcomes}
    recordings = {outcome.scenario.name: outcome.recording for outcome in outcomes if outcome.recording}
    bags = {outcome.scenario.name: outcome.bags for outcome in outcomes}
    bare = {outcome.scenario.name: outcome.bare for outcome in outcomes if outcome.bare}
    evidence = Evidence(scenarios, recordings, source, names, bags, bare)
    for check in checks:
        blocker = _blocker((LAUNCHES, *(need.name for need in check.needs)), results)
        result = _result(check, evidence) if blocker is None else _not_run(check, blocker, results)
        if result.status == FAILED and not result.share:
            blocker = _blocker(check.explained_by, results)
            result = result if blocker is None else _not_run(check, blocker, results)
        results[check.name] = result
    return with_causes(list(results.values()), evidence)


def _launches(outcomes: Sequence[Outcome], source: SubmittedText) -> CheckResult:
    """Return the result that states whether the launch file runs. A fault of the grader takes precedence over a student's
    mistake.
    """
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


def too_much(checks: Sequence[Check], why: str, source: SubmittedText) -> list[CheckResult]:
    """Return the results of a submission whose runs could not be judged within the limits of a worker.

    :param why: the limit that was exceeded, in words.
    """
    first = _unseen(CheckResult(LAUNCHES, LAUNCHES_SENTENCE, FAILED), why, source)
    return [first, *(_not_run(check, first, {LAUNCHES: first}) for check in checks)]


def _unseen(result: CheckResult, why: str, source: SubmittedText) -> CheckResult:
    return replace(
        result,
        reason=f'the grader cannot judge the recording of this run: {why}',
        where=source.place,
        try_='find a node that publishes without pause, or reduce the number of nodes',
    )


def broken(error: Exception) -> CheckResult:
    """Return the only result of a submission for which the grader itself broke."""
    reason, try_ = words_of(error)
    return no_mark(reason, try_)


def no_mark(reason: str, try_: str = 'find out who changes files there, and grade again') -> CheckResult:
    """Return the only result of a submission that gets no mark, for a reason that the student did not cause."""
    return CheckResult(LAUNCHES, LAUNCHES_SENTENCE, GRADER_BROKE, reason=reason, try_=try_)


def _which(bad: Sequence[Outcome], outcomes: Sequence[Outcome]) -> str | None:
    """Return words that name the launches that failed, or None if all launches failed."""
    if len(bad) == len(outcomes):
        return None
    runs = ', and with '.join(outcome.scenario.words for outcome in bad)
    return f'a failure in {len(bad)} of the {len(outcomes)} runs: with {runs}'


def _blocker(names: Sequence[str], results: Mapping[str, CheckResult]) -> CheckResult | None:
    return next((results[name] for name in names if name in results and results[name].status != PASSED), None)


def _not_run(check: Check, blocker: CheckResult, results: Mapping[str, CheckResult]) -> CheckResult:
    root = results[blocker.root_cause] if blocker.root_cause is not None else blocker
    reason = (
        f'because the grader failed in "{root.sentence}"' if root.status == GRADER_BROKE else f'because "{root.sentence}" failed'
    )
    return replace(_plain(check, NOT_RUN), root_cause=root.name, reason=reason)


def _result(check: Check, evidence: Evidence) -> CheckResult:
    try:
        with cpu_limit(LONGEST_CHECK_S):
            check(evidence)
    except TooLong as error:
        return _unseen(_plain(check, FAILED), str(error), evidence.source)
    except MemoryError:
        return _unseen(_plain(check, FAILED), 'the memory is full', evidence.source)
    except Failure as failure:
        failure.correct(evidence.source.texts().values())
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
    except Exception as error:  # any exception except Failure is a fault of the grader
        return replace(_plain(check, GRADER_BROKE), reason=_words(error, check), try_=REPORT_IT)
    return _plain(check, PASSED)


def _plain(check: Check, status: str) -> CheckResult:
    needs = tuple(need.name for need in check.needs)
    return CheckResult(check.name, check.sentence, status, check.points, needs)


def _words(error: Exception, check: Check) -> str:
    """Return a sentence with the type, message and place of an unexpected exception.

    The place is the line of the rubric or, if the rubric is not in the traceback, the line that raised the exception.
    """
    places = []
    trace = error.__traceback__
    while trace is not None:
        places.append((trace.tb_frame.f_code.co_filename, trace.tb_lineno))
        trace = trace.tb_next
    rubric = getattr(getattr(check.function, '__code__', None), 'co_filename', None)
    file, line = next((place for place in reversed(places) if place[0] == rubric), places[-1])
    return f'the check itself broke: {type(error).__name__}: {error} ({file}:{line})'


def judged(judge: Callable[[], Sequence[CheckResult]]) -> list[CheckResult]:
    """Return the results of `judge` from a worker, or one result that reports that the grader broke.

    :raises Exceeded: as in `in_worker`.
    :raises Lost: as in `in_worker`.
    """
    return [result_of(row) for row in in_worker(lambda: rows_of(judge))]


def rows_of(judge: Callable[[], Sequence[CheckResult]]) -> list[dict[str, Any]]:
    """Return the results of `judge` as plain data for `result_of`, or one result that reports that the grader broke."""
    try:
        results = judge()
    except MemoryError:
        raise  # the worker handles this error
    except Exception as error:
        results = [broken(error)]
    return [asdict(result) for result in results]


def result_of(row: dict[str, Any]) -> CheckResult:
    """Return a result from a row of `rows_of` after JSON has changed its types."""
    row['needs'] = tuple(row['needs'])
    row['steps'] = tuple(row['steps'])
    row['where'] = Place(*row['where']) if row['where'] else None
    if row['cause']:
        from edulaunch.advice.rule import Finding  # a submission that passes needs no causes, so the rules need not run

        row['cause'] = Finding(*row['cause'])
    return CheckResult(**row)


LONGEST_S = 2.0  # this usually takes a hundredth of this time
DIED = ' died with exit code '
COVERED_BY_CHECKS = ('launch.unknown-argument', 'programs.died', 'programs.interrupted', 'programs.rule-failed')
"""Rubrics report dead programs and missing arguments themselves. The arguments of a run come from the grader."""
SHORTEST_NAME, SHORTEST_OPTION = 4, 3
"""The fewest characters of a name that may be searched in a message, and of a name in advice."""


def with_causes(results: list[CheckResult], evidence: Evidence) -> list[CheckResult]:
    """Return the results with causes. Each finding becomes the cause of the failed check that it explains best, or of no check.

    A check has at most one cause. Marks do not depend on findings.
    """
    if not evidence or all(result.status != FAILED for result in results):
        return results
    kept = _with_last_line(results, evidence)
    found = _findings(evidence, any(map(_is_death, kept)))
    findings = [
        finding for finding in found if not any(_is_reported(finding, result) or _is_reversed(finding, result) for result in kept)
    ]
    fitting = [(finding, *_fitting(finding, kept)) for finding in findings]
    for finding, _, positions in sorted(fitting, key=lambda each: each[1]):  # the best fit comes first
        free = next((position for position in positions if kept[position].cause is None), None)
        if free is not None:
            kept[free] = replace(kept[free], cause=finding)
    return kept


def _fitting(finding: Finding, results: Sequence[CheckResult]) -> tuple[int, list[int]]:
    """Return the positions of the failed checks that a finding fits best, after the rank of this fit, which is 0 for the best.
    The finding explains no other check.
    """
    fits = (_has_both, _is_named, _is_near_in_node, _is_near, _is_there, _is_part, _is_in_advice)
    for rank, is_about in enumerate(fits):
        found = [at for at, result in enumerate(results) if result.status == FAILED and is_about(finding, result)]
        if found:
            return rank, found
    return len(fits), []


def _findings(evidence: Evidence, death_is_covered: bool) -> list[Finding]:
    """Return the findings of all runs, the worst first. Return an empty list if the rules take too long."""
    from edulaunch.advice.judging import in_order

    try:
        with cpu_limit(LONGEST_S):
            found = in_order([finding for recording in evidence.values() for finding in recording.advice])
    except MemoryError:
        raise
    except Exception:  # if a rule raises an error, the causes are missing, but the mark does not change
        return []
    covered = COVERED_BY_CHECKS if death_is_covered else tuple(rule for rule in COVERED_BY_CHECKS if rule != 'programs.died')
    kept = [finding for finding in found if finding.rule not in covered and not _is_of_the_grader(finding)]
    for position, finding in enumerate(kept):
        if finding.file is not None and is_shipped(finding.file):  # the student's line is the one that includes this file
            place = evidence.source.own((finding.file, finding.line), r'IncludeLaunchDescription\(|<include|include:')
            kept[position] = finding._replace(file=place.file, line=place.line)
    return list({(each.rule, each.name, each.file, each.line): each for each in reversed(kept)}.values())[::-1]


def _is_of_the_grader(finding: Finding) -> bool:
    """Return whether a finding is about the node that the grader adds to a run."""
    return f'/{VISITOR}' in (finding.name, finding.facts.get('node'), finding.facts.get('other'))


def _is_death(result: CheckResult) -> bool:
    """Return whether a result reports that a program died. Then the output of this program explains the failure."""
    return ' died ' in result.reason or DIED in (result.seen or '')


def _with_last_line(results: Sequence[CheckResult], evidence: Evidence) -> list[CheckResult]:
    """Return the results. If a program died and no check reports it, add its last line to the first failed check.

    Failed checks with the same reason as the first one get this line, too.
    """
    first = next((result for result in results if result.status == FAILED), None)
    if first is None or any(' died ' in result.reason for result in results):
        return list(results)
    try:
        with cpu_limit(LONGEST_S):
            words = words_on_deaths(evidence)
    except MemoryError:
        raise
    except Exception:  # for a hostile recording this line is missing, but the mark does not change
        words = ''
    alike = (first.reason, first.expected, first.seen, first.where)
    seen = '\n'.join(filter(None, (first.seen, words)))
    return [
        replace(result, seen=seen)
        if words and result.status == FAILED and (result.reason, result.expected, result.seen, result.where) == alike
        else result
        for result in results
    ]


def _is_reported(finding: Finding, result: CheckResult) -> bool:
    """Return whether a failed check itself reports that the thing of the finding does not exist."""
    if result.status != FAILED:
        return False
    if finding.rule == 'launch.parameter-file-absent':  # the check has an action that fits the package
        return str(finding.facts['path']) in result.reason
    return finding.facts.get('near') is None and result.reason == f'the {finding.kind} {finding.name} is missing'


def _is_reversed(finding: Finding, result: CheckResult) -> bool:
    """Return whether a finding suggests the name that a failed check has found in place of the name that the finding is about."""
    names = finding.name, finding.facts.get('near')
    where = result.expected or '', (result.seen or '').split('(')[0]
    # of a pair of topics, the rule itself decides which name is right
    return (
        result.status == FAILED
        and finding.kind != 'topic'
        and all(
            isinstance(name, str) and _names(name, text) and not _names(name, other)
            for name, text, other in zip(names, where, reversed(where), strict=True)
        )
    )


def _has_both(finding: Finding, result: CheckResult) -> bool:
    """Return whether a check names both the wrong name and the right name of a finding."""
    return _has_name(result, finding.facts.get('near')) and _is_named(finding, result)


def _is_named(finding: Finding, result: CheckResult) -> bool:
    """Return whether a check names the thing that a finding is about.

    If the finding suggests a name, the wrong name must occur outside the sentence of the check.
    """
    names = (finding.name, finding.name.strip('/'))
    shown = '\n'.join(filter(None, (result.reason, result.expected, result.seen)))
    return any(_has_name(result, name) and ('near' not in finding.facts or name in shown) for name in names)


def _is_near_in_node(finding: Finding, result: CheckResult) -> bool:
    """Return whether a check names the right name of a finding and the node that uses the wrong name."""
    node = str(finding.facts.get('node') or '').rpartition('/')[2]
    return _has_name(result, finding.facts.get('near')) and _has_name(result, node)


def _is_near(finding: Finding, result: CheckResult) -> bool:
    return _has_name(result, finding.facts.get('near'))


def _is_there(finding: Finding, result: CheckResult) -> bool:
    """Return whether a check is about the line of the finding, and about the same kind of thing."""
    is_line = result.where is not None and finding.file is not None and tuple(result.where) == (finding.file, finding.line)
    return is_line and re.search(rf'\b{finding.kind}s?\b', _words_of(result)) is not None


def _is_part(finding: Finding, result: CheckResult) -> bool:
    """Return whether a check names the turtle of a topic, the frame from which a lookup starts, or the joints of a robot."""
    topics = [str(topic) for topic in (finding.name, finding.facts.get('near')) if str(topic).endswith(('/cmd_vel', '/pose'))]
    turtles = [topic.rpartition('/')[0].strip('/') for topic in topics]
    words = result.reason.lstrip('/').split()
    is_its = any(turtle in words[:1] or words[1:3] == ['frame', turtle] for turtle in turtles)
    has_joint = 'joints' in finding.facts and 'joint' in _words_of(result)
    return is_its or has_joint or _has_name(result, finding.facts.get('target'))


def _is_in_advice(finding: Finding, result: CheckResult) -> bool:
    """Return whether the advice of a check contains the right name of a finding or an option of its program. For a remapping
    without an effect, its node is enough.
    """
    advice = ' '.join(filter(None, (*result.steps, result.try_)))
    node = finding.name.rpartition('/')[2] if finding.rule == 'launch.remapping-unused' else None
    option = str(finding.facts.get('option') or '').lstrip('-')
    names = (finding.facts.get('near'), node, option if finding.kind == 'process' else None)
    return any(isinstance(name, str) and len(name) >= SHORTEST_OPTION and _names(name.lstrip('-'), advice) for name in names)


def _has_name(result: CheckResult, name: object) -> bool:
    return isinstance(name, str) and len(name) >= SHORTEST_NAME and _names(name, _words_of(result))


def _names(name: str, text: str) -> bool:
    return re.search(rf'(?<![\w/]){re.escape(name)}(?![\w/])', text) is not None


def _words_of(result: CheckResult) -> str:
    return ' '.join(filter(None, (result.sentence, result.reason, result.expected, result.seen)))
