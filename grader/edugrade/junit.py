"""The report as JUnit XML, as continuous integration servers read it: a suite for each submission, a case for each check."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from xml.sax.saxutils import escape, quoteattr

from .results import FAILED, GRADER_BROKE, NOT_RUN, CheckResult, Refusal, Report
from .short_paths import ShortPaths

_ELEMENTS = {FAILED: 'failure', GRADER_BROKE: 'error', NOT_RUN: 'skipped'}


def junit_text(reports: Sequence[Report], refusals: Sequence[Refusal]) -> str:
    """All reports as one document. A path that could not be graded is a suite with one error."""
    lines = ['<?xml version="1.0" encoding="UTF-8"?>', '<testsuites name="edugrade">']
    for report in reports:
        lines += _suite(report)
    for refusal in refusals:
        lines += [
            _start('testsuite', {'name': refusal.given, 'tests': '1', 'failures': '0', 'errors': '1', 'skipped': '0'}),
            _start('testcase', {'classname': refusal.given, 'name': 'It can be graded'}),
            f'{_start("error", {"message": refusal.reason})}{_safe(refusal.help or "")}</error>',
            '</testcase>',
            '</testsuite>',
        ]
    return '\n'.join([*lines, '</testsuites>']) + '\n'


def _suite(report: Report) -> Iterator[str]:
    paths = ShortPaths(report.folder, report.shown, report.package)
    count = {status: sum(result.status == status for result in report.results) for status in _ELEMENTS}
    yield _start(
        'testsuite',
        {
            'name': f'{report.rubric}: {report.given}',
            'tests': str(len(report.results)),
            'failures': str(count[FAILED]),
            'errors': str(count[GRADER_BROKE]),
            'skipped': str(count[NOT_RUN]),
        },
    )
    points = 'no mark' if report.earned is None else f'{report.earned} of {report.possible}'
    yield '<properties>'
    for name, value in {'points': points, 'seed': str(report.seed), 'sha256': report.sha256}.items():
        yield _start('property', {'name': name, 'value': value}, '/>')
    yield '</properties>'
    for result in report.results:
        yield from _case(paths.result(result), report.rubric)
    yield '</testsuite>'


def _case(result: CheckResult, rubric: str) -> Iterator[str]:
    case = {'classname': f'edugrade.{rubric}', 'name': result.sentence}
    element = _ELEMENTS.get(result.status)
    if element is None:
        yield _start('testcase', case, '/>')
        return
    yield _start('testcase', case)
    yield f'{_start(element, {"message": result.reason})}{_safe(_details(result))}</{element}>'
    yield '</testcase>'


def _details(result: CheckResult) -> str:
    place = result.where
    where = None if place is None else place.file + (f':{place.line}' if place.line else '')
    fields = {'expected': result.expected, 'seen': result.seen, 'where': where, 'try': result.try_}
    return '\n'.join(f'{label}: {text}' for label, text in fields.items() if text)


def _start(name: str, attributes: Mapping[str, str], end: str = '>') -> str:
    words = ''.join(f' {key}={quoteattr(_legal(value))}' for key, value in attributes.items())
    return f'<{name}{words}{end}'


def _safe(text: str) -> str:
    return escape(_legal(text))


def _legal(text: str) -> str:
    """XML 1.0 has no way to write most control characters, and no half characters."""
    return ''.join(sign if sign.isprintable() or sign in '\n\t' else '?' for sign in text)
