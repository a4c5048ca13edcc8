"""What several reports came to, as a table."""

from __future__ import annotations

from collections.abc import Sequence

from .results import Refusal, Report
from .terminal import printable

HEAD = ('submission', 'result', 'checks', 'points')
TO_REPAIR = {'some failed': 'FAILED', 'unusable input': 'UNUSABLE', 'grader broke': 'BROKE'}  # words, not colours


def summary(reports: Sequence[Report], refusals: Sequence[Refusal]) -> str:
    """One line for each submission, and the sum of the points; then what could not be graded at all."""
    rows = [HEAD, *(_row(report) for report in reports)]
    rows += [(refusal.given, 'REFUSED', '-', '-') for refusal in refusals]
    rows.append(('sum', _result(reports, refusals), _checks(reports), _points(reports)))
    widths = [max(len(row[column]) for row in rows) for column in range(len(HEAD))]
    lines = ['  '.join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip() for row in rows]
    lines.insert(1, '-' * max(map(len, lines)))
    lines.insert(-1, lines[1])
    return '\n'.join([*map(printable, lines), *_refused(refusals)]) + '\n'


def _row(report: Report) -> tuple[str, ...]:
    mark = 'no mark' if report.earned is None else f'{report.earned} of {report.possible}'
    result = TO_REPAIR.get(report.verdict, report.verdict)
    return report.given, result, f'{report.passed} of {len(report.results)}', mark


def _result(reports: Sequence[Report], refusals: Sequence[Refusal]) -> str:
    passed = sum(report.exit_code == 0 for report in reports)
    return f'{passed} of {len(reports) + len(refusals)} passed'


def _checks(reports: Sequence[Report]) -> str:
    return f'{sum(report.passed for report in reports)} of {sum(len(report.results) for report in reports)}'


def _points(reports: Sequence[Report]) -> str:
    return f'{sum(report.earned or 0 for report in reports)} of {sum(report.possible for report in reports)}'


def _refused(refusals: Sequence[Refusal]) -> list[str]:
    lines = []
    for refusal in refusals:
        lines += ['', printable(f'{refusal.given} was not graded: {refusal.reason}')]
        lines += [printable(f'  help: {refusal.help}')] if refusal.help else []
    return lines
