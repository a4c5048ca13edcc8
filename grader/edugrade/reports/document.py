"""Creates the JSON report, which docs/report.md describes. FORMAT increases with changes that can break programs for the old
format.
"""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from edulaunch.runtime.version import __version__

from ..evidence import Outcome
from ..repeated import digest_of
from ..results import CheckResult, Refusal, Report
from ..source import Place
from ..worker import Exceeded, TooLong, cpu_limit, in_worker
from .wording import ShortPaths

if TYPE_CHECKING:
    from edulaunch.advice import Finding
    from edulaunch.engine.recording import Recording

    from ..grading import Work
    from ..variant import Variant

LONGEST_S = 2.0
MOST_LINES = 400
USUAL = ('/rosout', '/parameter_events')


def launch_graph(recording: Recording | None) -> list[str]:
    """Return sorted lines: one for each program, and one for each connection between two programs.

    The line of a program contains the names of its parameters. No line contains names of nodes or topics, so
    that a copy with other names has the same graph. For a recording that cannot be read, return [].
    """
    if recording is None:
        return []
    try:
        with cpu_limit(LONGEST_S):
            return sorted(_programs(recording) + _connections(recording))[:MOST_LINES]
    except (TooLong, AttributeError, TypeError, ValueError, LookupError, RecursionError):  # hostile recordings
        return []


def _programs(recording: Recording) -> list[str]:
    return [
        f'starts {process.package}/{process.executable}' + ''.join(f' {name}' for name in sorted(process.parameter_origins))
        if process.package
        else f'runs {process.argv[0].split()[0] if process.argv else ""}'
        for process in recording.processes
        if process.name != 'launch'
    ]


def _connections(recording: Recording) -> list[str]:
    programs = {process.name: f'{process.package}/{process.executable}' for process in recording.processes}
    owner = {node.name: programs.get(node.process, '?') for node in recording.nodes}
    return [
        f'{owner.get(speaker, "?")} tells {owner.get(listener, "?")} {topic.type}'
        for topic in recording.topics.values()
        if topic.name not in USUAL and topic.count
        for speaker in topic.publishers
        for listener in topic.subscriptions
    ]


def explanation(check: Mapping[str, Any]) -> list[str]:
    """Return the lines ``label: value`` that follow the reason of a check."""
    where = None if check['where'] is None else Place(**check['where'])
    fields = {'expected': check['expected'], 'seen': check['seen'], 'where': where, 'try': check['try']}
    return [f'{label}: {text}' for label, text in fields.items() if text]


def receipt(made: Work | Report) -> dict[str, Any]:
    """Return the digests of the submission and the rubric, the version of edulaunch, the seed, and the name of the secret."""
    return {
        'submission': made.sha256,
        'rubric': made.rubric_sha256,
        'edulaunch': __version__,
        'seed': made.seed,
        'secret': made.secret,
    }


FORMAT = 2


def document(report: Report) -> dict[str, Any]:
    """Return a report as plain data. Paths in the submission's directory are relative, so that copies have equal reports."""
    paths = ShortPaths(report.folder, package=report.package)
    digests, graph = report.looked or _looked_at(report.outcomes)
    return {
        'format': FORMAT,
        **({'student': report.student} if report.student else {}),
        'submission': {'file': os.path.relpath(report.file, report.folder), 'sha256': report.sha256},
        'rubric': {'name': report.rubric, 'title': report.title},
        'seed': report.seed,
        **({'variant': _variant(report.variant)} if report.variant else {}),
        'receipt': receipt(report),
        'verdict': report.verdict,
        'exit_code': report.exit_code,
        'points': {'earned': report.earned, 'possible': report.possible},
        'sandbox': report.sandbox,
        'scenarios': [_scenario(*each, paths) for each in zip(report.outcomes, digests, strict=True)],
        'checks': [_check(paths.result(result), paths) for result in report.results],
        'graph': graph,
        'gaps': [{'file': paths.text(gap.file), 'line': gap.line, 'text': gap.text} for gap in report.gaps],
    }


def _variant(variant: Variant) -> dict[str, Any]:
    return {'student': variant.student, 'tag': variant.tag, 'values': dict(variant.values)}


def _looked_at(outcomes: Sequence[Outcome]) -> tuple[list[str | None], list[str]]:
    """Return the result of `look_at`, which is computed in a worker if it is not known yet."""
    try:
        digests, graph = in_worker(lambda: look_at(outcomes))
    except Exceeded:
        return [None] * len(outcomes), []
    return digests, graph


def look_at(outcomes: Sequence[Outcome]) -> tuple[list[str | None], list[str]]:
    """Return the digest of each run and the launch graph of the first run. Call this in a worker."""
    return [digest_of(each) for each in outcomes], launch_graph(outcomes[0].recording)


def document_of_all(reports: Sequence[Report], refusals: Sequence[Refusal], exit_code: int) -> dict[str, Any]:
    """Return several reports as plain data, together with the paths that could not be graded."""
    return {
        'format': FORMAT,
        'exit_code': exit_code,
        'reports': [document(report) for report in reports],
        'refused': [{'given': item.given, 'reason': item.reason, 'help': item.help} for item in refusals],
    }


def json_text(data: dict[str, Any]) -> str:
    """Return a document as a JSON string."""
    return json.dumps(data, indent=2, ensure_ascii=False) + '\n'


def _scenario(outcome: Outcome, digest: str | None, paths: ShortPaths) -> dict[str, Any]:
    scenario = outcome.scenario
    return {
        'name': scenario.name,
        'arguments': dict(scenario.arguments),
        'duration_s': scenario.duration_s,
        'seed': scenario.seed,
        'digest': digest,
        'outcome': outcome.kind,
        **({'refused_calls': list(outcome.refused)} if outcome.refused else {}),
        'text': paths.text(outcome.text) or None,
        'detail': paths.text(outcome.detail) or None,
    }


def _cause(finding: Finding, paths: ShortPaths) -> dict[str, Any]:
    """Return a finding as plain data. Its sentences are in English, whatever the language of the reader."""
    from edulaunch.advice import Reader, rendered

    words = rendered(finding, Reader())
    where = None if finding.file is None else {'file': paths.text(finding.file), 'line': finding.line}
    return {'rule': finding.rule, 'what': paths.text(words.what), 'where': where, 'try': paths.text(words.do)}


def _check(result: CheckResult, paths: ShortPaths) -> dict[str, Any]:
    return {
        'name': result.name,
        'sentence': result.sentence,
        'status': result.status,
        'points': result.points,
        'earned': result.earned,
        'needs': list(result.needs),
        'reason': result.reason or None,
        'expected': result.expected,
        'seen': result.seen,
        'where': None if result.where is None else result.where._asdict(),
        'try': result.try_,
        'root_cause': result.root_cause,
        'cause': None if result.cause is None else _cause(result.cause, paths),
    }
