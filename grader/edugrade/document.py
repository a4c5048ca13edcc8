"""The JSON report. docs/grading.md describes it; FORMAT grows when a reader of the old one could err."""

from __future__ import annotations

import json
import os
from typing import Any

from edulaunch.errors import UnusableInput

from .outcome import Outcome
from .results import CheckResult, Report
from .short_paths import ShortPaths

FORMAT = 1
VERDICTS = ('all passed', 'some failed', 'unusable input', 'grader broke')


def document(report: Report) -> dict[str, Any]:
    """A report as plain data. Paths in the submission's folder are relative, so that copies report alike."""
    paths = ShortPaths(os.path.dirname(report.file))
    return {
        'format': FORMAT,
        'submission': {'file': os.path.basename(report.file), 'sha256': report.sha256},
        'rubric': {'name': report.rubric, 'title': report.title},
        'seed': report.seed,
        'verdict': VERDICTS[report.exit_code],
        'exit_code': report.exit_code,
        'points': {'earned': report.earned, 'possible': report.possible},
        'scenarios': [_scenario(outcome, paths) for outcome in report.outcomes],
        'checks': [_check(paths.result(result)) for result in report.results],
        'gaps': [{'line': line, 'text': text} for line, text in report.gaps],
    }


def write_document(report: Report, path: str) -> None:
    """Write the JSON report, whole or not at all.

    :raises UnusableInput: when it cannot be written there.
    """
    temporary = f'{path}.{os.getpid()}.part'
    try:
        with open(temporary, 'w', encoding='utf-8') as file:
            json.dump(document(report), file, indent=2, ensure_ascii=False)
            file.write('\n')
        os.replace(temporary, path)
    except OSError as error:
        raise UnusableInput(
            f'the report {path} cannot be written: {error.strerror or error}',
            help='give --json a file in a folder that exists and that you may write to',
        ) from None


def _scenario(outcome: Outcome, paths: ShortPaths) -> dict[str, Any]:
    scenario = outcome.scenario
    return {
        'name': scenario.name,
        'arguments': dict(scenario.arguments),
        'duration_s': scenario.duration_s,
        'seed': scenario.seed,
        'outcome': outcome.kind,
        'text': paths.text(outcome.text) or None,
        'detail': paths.text(outcome.detail) or None,
    }


def _check(result: CheckResult) -> dict[str, Any]:
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
    }
