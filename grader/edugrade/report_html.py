"""A report as HTML: for the page that ``--html`` writes, and for a cell of a notebook."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from .language import explained, points_of, retold
from .markup import Markup, element, joined
from .results import FAILED, GRADER_BROKE, NOT_RUN, PASSED, CheckResult, Report
from .short_paths import ShortPaths
from .steps import at_level
from .terminal import MARKS, MORE, next_step, points_line, says_less, why_line

if TYPE_CHECKING:
    from edulaunch.advice import Reader

COLOURS = {PASSED: '#1a6e2e', FAILED: '#a3231f', NOT_RUN: '#7a5b00', GRADER_BROKE: '#6b2a8c'}
_MARK = 'display:inline-block;min-width:4.6em;font-weight:bold;color:'
_FIELDS = 'border-collapse:collapse;margin:.3em 0 .3em 4.6em'
_LABEL = 'text-align:left;vertical-align:top;padding:.1em .8em .1em 0;font-weight:normal;opacity:.75'
_VALUE = 'text-align:left;vertical-align:top;white-space:pre-wrap;font-family:monospace;padding:.1em 0'


def report_html(report: Report) -> Markup:
    """What to repair first, what was not run for it, what is right, points and the next step."""
    from edulaunch.advice import reader_here

    reader = reader_here()
    paths = ShortPaths(report.folder, report.shown, report.package)
    results = [paths.result(retold(at_level(result, report.level), reader)) for result in report.results]
    repair = [
        _failed(result, paths, reader, report.level)
        for status in (GRADER_BROKE, FAILED)
        for result in results
        if result.status == status
    ]
    right = [_line(result, reader) for result in results if result.status == PASSED]
    word = [element('p', element('b', reader.retells(report.word)))] if report.word else []
    return joined(
        *word,
        *repair,
        *_not_run(results, reader),
        *right,
        *([element('p', why_line(report), style='margin:.8em 0 .2em')] if report.why else []),
        element('p', reader.retells(points_line(report)), style='margin:.8em 0 .2em'),
        element('p', element('b', reader.retells(next_step(report))), style='margin:.2em 0'),
        *([element('p', reader.retells(MORE), style='margin:.2em 0')] if says_less(report) else []),
    )


def _line(result: CheckResult, reader: Reader, indent: str = '0') -> Markup:
    mark = element('span', reader.says(MARKS[result.status]), style=_MARK + COLOURS[result.status])
    return element(
        'div', mark, result.sentence, element('small', points_of(result, reader)), style=f'margin:.15em 0 .15em {indent}'
    )


def _failed(result: CheckResult, paths: ShortPaths, reader: Reader, level: int) -> Markup:
    rows = [
        element('tr', element('th', label, style=_LABEL), element('td', text, style=_VALUE))
        for label, text in explained(result, paths, reader, level).items()
    ]
    reason = element('div', result.reason, style='margin:.2em 0 .2em 4.6em;white-space:pre-wrap')
    return joined(_line(result, reader), reason, element('table', *rows, style=_FIELDS))


def _not_run(results: list[CheckResult], reader: Reader) -> Iterator[Markup]:
    """The checks that were not run, under the one to repair."""
    waiting = [result for result in results if result.status == NOT_RUN]
    for reason in dict.fromkeys(result.reason for result in waiting):
        mark = element('span', reader.says(MARKS[NOT_RUN]), style=_MARK + COLOURS[NOT_RUN])
        yield element('div', mark, f'{reason}:', style='margin:.15em 0')
        yield element(
            'ul',
            *(
                element('li', result.sentence, element('small', f'  [0 of {result.points}]' if result.points else ''))
                for result in waiting
                if result.reason == reason
            ),
            style='margin:.1em 0 .1em 4.6em;padding-left:1em',
        )
