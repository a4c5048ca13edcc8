"""What the rules of `edulaunch.advice` find in the runs, put to the checks that failed: the likely cause."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from .cpu_limit import TooLong, cpu_limit
from .evidence import Evidence
from .results import FAILED, CheckResult

if TYPE_CHECKING:
    from edulaunch.advice import Finding

LONGEST_S = 2.0  # usual: a hundredth of it
SAID_BY_CHECKS = ('launch.unknown-argument', 'programs.died', 'programs.interrupted', 'programs.rule-failed')
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
    told: list[CheckResult] = []
    for result in results:
        cause = next((finding for finding in findings if _is_about(finding, result)), None) if result.status == FAILED else None
        if cause is not None:
            findings.remove(cause)
            result = replace(result, cause=cause)
        told.append(result)
    return told if any(result.cause for result in told) else _with_worst(told, findings)


def _findings(evidence: Evidence, died_is_said: bool) -> list[Finding]:
    """Of all runs, the worst first; none when there is so much that it takes too long."""
    from edulaunch.advice.judging import in_order

    try:
        with cpu_limit(LONGEST_S):
            found = in_order([finding for recording in evidence.values() for finding in recording.advice])
    except TooLong:
        return []
    said = SAID_BY_CHECKS if died_is_said else tuple(rule for rule in SAID_BY_CHECKS if rule != 'programs.died')
    return [finding for finding in found if finding.rule not in said]


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
    from edulaunch.advice.registry import rule_named

    worst = next((finding for finding in findings if rule_named(finding.rule).level == 'error'), None)
    weightiest = max((result for result in results if result.status == FAILED), key=lambda result: result.points)
    return [replace(result, cause=worst) if result is weightiest else result for result in results]
