"""The report for people. Marks are words; colour only repeats them."""

from __future__ import annotations

import os
import textwrap
from collections.abc import Iterator

from .document import relative
from .results import ALL_PASSED, BROKEN_GRADER, FAILED, GRADER_BROKE, NOT_RUN, PASSED, CheckResult, Report

MARKS = {PASSED: 'ok', FAILED: 'FAILED', NOT_RUN: 'not run', GRADER_BROKE: 'BROKE'}
COLOURS = {PASSED: '32', FAILED: '31', NOT_RUN: '33', GRADER_BROKE: '35'}
WIDTH = 100
INDENT = ' ' * 9


def render(report: Report, *, colour: bool = False) -> str:
    """The whole report: what to repair, what was not run for it, what is right, points, the next step."""
    folder = os.path.dirname(report.file)
    shown = os.path.join(os.path.dirname(report.given), '')
    lines = [f'{report.given}: {report.title} (rubric {report.rubric}, seed {report.seed})', '']
    for status in (GRADER_BROKE, FAILED, NOT_RUN, PASSED):
        for result in report.results:
            if result.status == status:
                lines += _check(result, colour)
    lines += ['', _points(report), *_next(report)]
    return '\n'.join(relative(line, folder, shown) or '' for line in lines) + '\n'


def _check(result: CheckResult, colour: bool) -> Iterator[str]:
    mark = f'{MARKS[result.status]:<9}'
    if colour:
        mark = f'\x1b[{COLOURS[result.status]}m{mark}\x1b[0m'
    worth = f'  [{result.earned} of {result.points}]' if result.points else ''
    yield f'{mark}{result.sentence}{worth}'
    if result.status == NOT_RUN:
        yield f'{INDENT}{result.reason}'
    elif result.status != PASSED:
        yield from _explanation(result)


def _explanation(result: CheckResult) -> Iterator[str]:
    yield from _wrapped('', result.reason)
    place = (
        None
        if result.where is None
        else result.where.file + (f':{result.where.line}' if result.where.line else '')
    )
    for label, text in (
        ('expected', result.expected),
        ('seen', result.seen),
        ('where', place),
        ('try', result.try_),
    ):
        if text:
            yield from _wrapped(f'{label}:', text)


def _wrapped(label: str, text: str) -> Iterator[str]:
    head = f'{label:<10}' if label else ''
    for paragraph in text.splitlines() or ['']:
        yield from textwrap.wrap(
            paragraph,
            WIDTH,
            initial_indent=INDENT + head,
            subsequent_indent=INDENT + ' ' * len(head),
            break_long_words=False,
            break_on_hyphens=False,
        ) or ['']
        head = ' ' * len(head)


def _points(report: Report) -> str:
    count = sum(result.status == PASSED for result in report.results)
    points = (
        'no mark, because the grader broke'
        if report.earned is None
        else f'{report.earned} of {report.possible} points'
    )
    return f'{count} of {len(report.results)} checks passed: {points}.'


def _next(report: Report) -> Iterator[str]:
    """The closing line: the one thing to do now."""
    if report.exit_code == ALL_PASSED:
        yield 'Next: done. Take the next exercise, or change something and predict what the report will say.'
        return
    if report.exit_code == BROKEN_GRADER:
        yield 'Next: this is not your mistake. Please report what BROKE above, with the launch file.'
        return
    first = next(result for result in report.results if result.status == FAILED)
    if report.gaps and first.root_cause is None and first.where is not None:
        line, text = report.gaps[0]
        yield f'Next: line {line} of {report.given} still says "{text}". Fill it in and grade again.'
    else:
        yield f'Next: repair "{first.sentence}" and grade again.'
