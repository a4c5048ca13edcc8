"""Formats the report for a terminal. Colours repeat the statuses, so the report is complete without them."""

from __future__ import annotations

import textwrap
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import TYPE_CHECKING

from ..results import ALL_PASSED, BROKEN_GRADER, FAILED, GRADER_BROKE, NOT_RUN, OWN_VARIANT, PASSED, CheckResult, Report
from ..verdicts import refusal_of
from .wording import ALL, ShortPaths, at_level, explained, points_of, translated

if TYPE_CHECKING:
    from edulaunch.advice import Reader

MARKS = {PASSED: 'ok', FAILED: 'FAILED', NOT_RUN: 'not run', GRADER_BROKE: 'BROKE'}
COLOURS = {PASSED: '32', FAILED: '31', NOT_RUN: '33', GRADER_BROKE: '35'}
WIDTH = 100
MORE = 'After more attempts with a changed file, this advice becomes more specific.'
INDENT = ' ' * 9


def render(report: Report, *, colour: bool = False) -> str:
    """Return the whole report: failed checks, checks that were not run, passed checks, points, and the next step."""
    from edulaunch.advice import reader_here

    reader = reader_here()
    paths = ShortPaths(report.folder, report.shown, report.package)
    results = [paths.result(translated(at_level(result, report.level), reader)) for result in report.results]
    mark = partial(_coloured_mark if colour else _plain_mark, reader)
    seed = reader.retells(f'(rubric {report.rubric}, seed {report.seed})')
    title = f'{report.given}: {reader.retells(report.title)} {seed}'
    lines = [printable(title), *([printable(reader.retells(report.word))] if report.word else []), '']
    for status in (GRADER_BROKE, FAILED):
        for alike in of_one_cause([*_of(status, results)]):
            lines += [mark(status) + _title(result, reader) for result in alike]
            lines += _explanation(best_explained(alike), paths, reader, report.level)
    lines += _not_run(results, mark, reader)
    lines += [mark(PASSED) + _title(result, reader) for result in _of(PASSED, results)]
    lines += ['', *textwrap.wrap(refusal_of(report.refused), WIDTH)] if report.refused else []
    next_ = printable(reader.retells(next_step(report)))
    lines += ['', *textwrap.wrap(printable(why_line(report)), WIDTH)] if report.why else []
    lines += ['', reader.retells(points_line(report)), *textwrap.wrap(next_, WIDTH, break_on_hyphens=False)]
    lines += [reader.retells(MORE)] if says_less(report) else []
    return '\n'.join(lines) + '\n'


def _of(status: str, results: list[CheckResult]) -> Iterator[CheckResult]:
    return (result for result in results if result.status == status)


def of_one_cause(results: Sequence[CheckResult]) -> list[list[CheckResult]]:
    """Return the results in blocks. Checks that fail for the same reason at the same place are in one block."""
    blocks: dict[object, list[CheckResult]] = {}
    for result in results:
        blocks.setdefault((result.reason, result.expected, result.seen, result.where), []).append(result)
    return list(blocks.values())


def best_explained(alike: Sequence[CheckResult]) -> CheckResult:
    """Return the result of a block whose explanation the report shows: the first result with a cause, or else the first
    result.
    """
    return next((result for result in alike if result.cause is not None), alike[0])


def _plain_mark(reader: Reader, status: str) -> str:
    return f'{reader.says(MARKS[status]):<9}'


def _coloured_mark(reader: Reader, status: str) -> str:
    return f'\x1b[{COLOURS[status]}m{_plain_mark(reader, status)}\x1b[0m'


def _title(result: CheckResult, reader: Reader) -> str:
    return result.sentence + points_of(result, reader)


def _explanation(result: CheckResult, paths: ShortPaths, reader: Reader, level: int) -> Iterator[str]:
    yield from _wrapped('', result.reason)
    for label, text in explained(result, paths, reader, level).items():
        yield from _wrapped(f'{label}:', text)


def _wrapped(label: str, text: str) -> Iterator[str]:
    """Yield the lines of a string, with a label before the first line and an indentation before the others."""
    margin = INDENT + (f'{label:<10}' if label else '')
    for line in printable(text).splitlines():
        indent = ' ' * (len(line) - len(line.lstrip()))
        yield from textwrap.wrap(
            line.strip(),
            WIDTH,
            initial_indent=margin + indent,
            subsequent_indent=' ' * len(margin) + indent + ('  ' if indent else ''),
            break_long_words=False,
            break_on_hyphens=False,
        )
        margin = ' ' * len(margin)


def printable(text: str) -> str:
    """Replace control characters, so that output of a submission cannot move the cursor or overwrite the report."""
    return ''.join(sign if sign.isprintable() or sign == '\n' else '?' for sign in text)


def _not_run(results: list[CheckResult], mark: Callable[[str], str], reader: Reader) -> Iterator[str]:
    """Yield the checks that were not run, grouped by the failed check that they need."""
    reasons = dict.fromkeys(result.reason for result in _of(NOT_RUN, results))
    for reason in reasons:
        yield f'{mark(NOT_RUN)}{reason}:'
        folded = (result for result in _of(NOT_RUN, results) if result.reason == reason)
        yield from (f'{INDENT}  {_title(result, reader)}' for result in folded)


def why_line(report: Report) -> str:
    """Return the sentence on robots that students get when all checks pass."""
    return f'On a robot: {report.why}'


def says_less(report: Report) -> bool:
    """Return whether the student gets more specific advice after further attempts."""
    return report.is_counted and any(at_level(result, report.level) != at_level(result, ALL) for result in report.results)


def points_line(report: Report) -> str:
    """Return a sentence with the number of passed checks and the points."""
    mark = f'{report.earned} of {report.possible} points'
    if report.earned is None:
        mark = f'no mark, because {_why_none(report)}'
    return f'{report.passed} of {len(report.results)} checks passed: {mark}.'


def _why_none(report: Report) -> str:
    reasons = [result.reason for result in report.results if result.status == GRADER_BROKE]
    if any(result.name == OWN_VARIANT for result in report.results):
        return "this is another student's exercise"
    return reasons[0].removeprefix('not graded: ') if reasons[0].startswith('not graded: ') else 'the grader broke'


def sandbox_line(reports: Sequence[Report]) -> str:
    """Return a sentence about the layers of the sandbox that confined the runs, or '' if no run has reported layers."""
    if reports and not any(report.has_run for report in reports):
        return 'sandbox: not needed. Nothing of the submission was run.'
    states = [report.sandbox for report in reports if report.has_run]
    if not any(states):
        return 'sandbox: off. The submission could read, write and send everything that you can.' if states else ''
    missing = {layer: reason for state in states for layer, reason in state.items() if reason != 'held'}
    held = [layer for state in states[:1] for layer in state if layer not in missing]
    if not missing:
        return 'sandbox: the submission had no access to the network, to other programs, or to files that it does not need.'
    words = f'sandbox: these layers restricted the submission: {", ".join(held) or "none"}.'
    return f'{words} These layers were MISSING: {", ".join(f"{layer} ({reason})" for layer, reason in missing.items())}.'


def next_step(report: Report) -> str:
    """Return the last line of the report, which states what to do next. If a check failed, it is about the first failed check."""
    if report.exit_code == ALL_PASSED:
        return 'Next: start another exercise, or change a value here and predict the next report.'
    if any(result.name == OWN_VARIANT for result in report.results):
        return 'Next: start from your own starter file, or ask your teacher to look at this one.'
    if report.exit_code == BROKEN_GRADER:
        return 'Next: show this report and the launch file to your teacher. This is not your mistake.'
    first = next(_of(FAILED, list(report.results)))
    is_package = report.package is not None
    if report.gaps and not any(outcome.recording is None for outcome in report.outcomes):
        lines = ', '.join(str(gap.line) for gap in report.gaps)
        if is_package:
            return (
                f'Next: make the check "{first.sentence}" pass, and grade the package again. '
                f'Lines that still have a "# TODO" comment: {lines}'
            )
        return (
            f'Next: make the check "{first.sentence}" pass, and grade the file again. '
            f'Lines that still have a "# TODO" comment: {lines}'
        )
    if is_package:
        return f'Next: make the check "{first.sentence}" pass, and grade the package again.'
    return f'Next: make the check "{first.sentence}" pass, and grade the file again.'
