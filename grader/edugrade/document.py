"""The JSON report. docs/grading.md describes it; FORMAT grows when a reader of the old one could err."""

from __future__ import annotations

import json
import os
from typing import Any

from edulaunch.errors import UnusableInput

from .outcome import Outcome
from .place import Place
from .results import CheckResult, Report

FORMAT = 1
VERDICTS = ('all passed', 'some failed', 'unusable input', 'grader broke')


def document(report: Report) -> dict[str, Any]:
    """A report as plain data. Paths in the submission's folder are relative, so that copies report alike."""
    folder = os.path.dirname(report.file)
    return {
        'format': FORMAT,
        'submission': {'file': os.path.basename(report.file), 'sha256': report.sha256},
        'rubric': {'name': report.rubric, 'title': report.title},
        'seed': report.seed,
        'verdict': VERDICTS[report.exit_code],
        'exit_code': report.exit_code,
        'points': {'earned': report.earned, 'possible': report.possible},
        'scenarios': [_scenario(outcome, folder) for outcome in report.outcomes],
        'checks': [_check(result, folder) for result in report.results],
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


def _scenario(outcome: Outcome, folder: str) -> dict[str, Any]:
    scenario = outcome.scenario
    return {
        'name': scenario.name,
        'arguments': dict(scenario.arguments),
        'duration_s': scenario.duration_s,
        'seed': scenario.seed,
        'outcome': outcome.kind,
        'text': relative(outcome.text, folder) or None,
        'detail': outcome.detail or None,
    }


def _check(result: CheckResult, folder: str) -> dict[str, Any]:
    return {
        'name': result.name,
        'sentence': result.sentence,
        'status': result.status,
        'points': result.points,
        'earned': result.earned,
        'needs': list(result.needs),
        'reason': relative(result.reason, folder) or None,
        'expected': relative(result.expected, folder),
        'seen': relative(result.seen, folder),
        'where': _where(result.where, folder),
        'try': relative(result.try_, folder),
        'root_cause': result.root_cause,
    }


def _where(place: Place | None, folder: str) -> dict[str, Any] | None:
    return None if place is None else {'file': relative(place.file, folder), 'line': place.line}


def relative(text: str | None, folder: str, shown: str = '') -> str | None:
    """A text with the paths in `folder` shortened to `shown`."""
    return None if text is None else text.replace(folder + os.sep, shown)
