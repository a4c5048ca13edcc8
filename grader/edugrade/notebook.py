"""``check('circle')`` in a notebook cell: grades with the same rubric as the command, and shows the report in the notebook."""

from __future__ import annotations

import os
from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

from edulaunch.advice import reader_here
from edulaunch.errors import UnusableInput

from .attempts import find_hint, opened, record_attempt
from .course import HIGHEST, find_course, read_course
from .grading import grade, plan_work
from .reports.markup import Markup, element, joined
from .reports.page import report_html
from .reports.terminal import render
from .reports.theme import NOTEBOOK
from .results import ALL_PASSED, Report
from .rubric import RubricMistake
from .submission import ENDINGS, Submission
from .turn import find_turn, grade_turn, turns

_BOX = 'border-left:4px solid #888;padding:.2em 1em;max-width:60em;overflow-wrap:anywhere'


class CheckReport:
    """The report that :func:`check` shows, as HTML in a notebook and as plain text elsewhere."""

    def __init__(self, report: Report) -> None:
        self.report = report

    @property
    def passed(self) -> bool:
        """Whether all checks passed."""
        return self.report.exit_code == ALL_PASSED

    @property
    def headline(self) -> str:
        """The result as one line."""
        report = self.report
        reader = reader_here()
        mark = reader.retells('no mark' if report.earned is None else f'{report.earned} of {report.possible} points')
        return f'{report.rubric}: {reader.retells(report.verdict)}, {mark}'

    def __repr__(self) -> str:
        return f'{self.headline}\n\n{render(self.report)}'.rstrip('\n')

    def _repr_html_(self) -> str:
        head = element('p', element('b', self.headline), f' {self.report.given}', style='margin:.2em 0 .6em')
        theme = element('style', Markup(NOTEBOOK))
        return element('div', joined(theme, head, report_html(self.report)), style=_BOX, class_='edugrade')


class Note:
    """A short message to the student: a hint, or the reason why nothing was graded."""

    def __init__(self, text: str) -> None:
        self.text = text

    def __repr__(self) -> str:
        return self.text

    def _repr_html_(self) -> str:
        return element('div', self.text, style=f'{_BOX};white-space:pre-wrap')


def check(exercise: str, *, hint: int | None = None, names: Mapping[str, Any] = MappingProxyType({})) -> CheckReport | Note:
    """Grade an exercise or a task of a lesson, and record the attempt. With `hint`, show a hint instead, and record that.

    :param exercise: the name of the exercise or task, or the path of a launch file or package.
    :param hint: the level of the hint (1 to 3), or None to grade.
    :param names: the names that the cells have defined, with their values.
    """
    try:
        turn = find_turn(os.fspath(exercise))
        if turn is not None:
            if hint is not None:
                return Note('The hints of this task are below its cell in the lesson.')
            return CheckReport(record_attempt(grade_turn(exercise, turn, names), os.getcwd()))
        submission = Submission(find_exercise(os.fspath(exercise)))
        return _graded(submission) if hint is None else _hint(submission, hint)
    except UnusableInput as error:
        return Note(f'{error}')
    except RubricMistake as error:
        return Note(f'the rubric is wrong: {error}')


def find_exercise(name: str) -> str:
    """Return the path of a student's file in this directory or a parent. The path is relative where possible.

    :param name: the name of an exercise, or a path.
    :raises UnusableInput: if no exercise has this name (the message contains the nearest name), or if the file does not
        exist.
    """
    known = {entry.name: entry for entry in read_course(find_course(os.getcwd()))}
    if name not in known:
        if os.sep in name or name.endswith(ENDINGS) or os.path.exists(name):
            return name
        raise _unknown(name, [*known, *turns()])
    entry = known[name]
    folder = '.'
    for _ in range(HIGHEST):
        for place in (os.path.join(folder, 'exercises', entry.path), os.path.join(folder, entry.path)):
            if os.path.exists(place):
                return os.path.normpath(place)
        folder = os.path.join(folder, os.pardir)
    raise UnusableInput(
        f'there is no exercises/{entry.path} in {os.getcwd()} or in a folder above it',
        help=f'write the path, such as check("some/folder/{entry.path}")',
    )


def _unknown(name: str, known: list[str]) -> UnusableInput:
    from edulaunch.engine.nearest import nearest_few

    close = ' or '.join(f'check("{name}")' for name in nearest_few(name, known, 3))
    correction = f'write {close}, or ' if close else ''
    return UnusableInput(f'there is no exercise "{name}"', help=f'{correction}list all exercises with %edulaunch course list')


def _graded(submission: Submission) -> CheckReport:
    (report,) = grade([plan_work(submission)])
    return CheckReport(record_attempt(report, os.getcwd()))


def _hint(submission: Submission, level: int) -> Note:
    text = find_hint(submission, level)
    return Note('\n\n'.join(filter(None, (text, opened(submission.exercise, level, os.getcwd())))))
