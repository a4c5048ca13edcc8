"""``progress()``: show the progress of a student, lesson by lesson, and what to repeat."""

from __future__ import annotations

import os
from typing import NamedTuple

from edugrade.course import find_course, read_course
from edugrade.progress_file import NAME, ProgressFile
from edugrade.reports.markup import element, joined

from edulaunch.errors import UnusableInput

from .lessons import Lesson, lessons_folder, read_lessons
from .predictions import Verdict
from .questions import Question, find_questions

HEAD = ('lesson', 'predictions', 'questions', 'exercises', 'points')
MOST_REPEATED = 5


class Row(NamedTuple):
    """The progress in one lesson. Each entry has the form "done of all". An entry is empty if there is nothing to do."""

    title: str
    predictions: str
    questions: str
    exercises: str
    points: str


class ProgressPage:
    """The table of lessons and a list of work to repeat, as text, and as HTML in a notebook."""

    def __init__(self, rows: list[Row], repeat: list[str]) -> None:
        self.rows = rows
        self.repeat = repeat

    @property
    def advice(self) -> str:
        """Return one line that says what to do next."""
        return f'To repeat: {"; ".join(self.repeat)}.' if self.repeat else 'Nothing to repeat.'

    def __repr__(self) -> str:
        table = [HEAD, *self.rows]
        widths = [max(len(row[column]) for row in table) for column in range(len(HEAD))]
        lines = ['  '.join(f'{cell:<{width}}' for cell, width in zip(row, widths, strict=True)).rstrip() for row in table]
        return '\n'.join([*lines, '', self.advice])

    def _repr_html_(self) -> str:
        head = element('tr', *(element('th', word, scope='col') for word in HEAD))
        rows = [
            element('tr', element('th', row[0], scope='row'), *(element('td', cell) for cell in row[1:])) for row in self.rows
        ]
        return joined(element('table', head, *rows), element('p', self.advice))


def progress() -> ProgressPage | Verdict:
    """Return the lessons with predictions, answers and solved exercises, from the file ``my_progress.toml``.

    The file is in this folder or else in the folder with the lessons.
    """
    folder = lessons_folder()
    if folder is None:
        return Verdict(
            'There are no lessons here. Type `edulaunch course status` in the course folder, or call progress() in a lesson.'
        )
    file = ProgressFile(os.getcwd() if os.path.isfile(NAME) else folder)
    questions = list(find_questions().questions.values())
    rows = [_row(lesson, file, questions) for lesson in read_lessons(folder)]
    return ProgressPage(rows, _to_repeat(file, questions))


def _row(lesson: Lesson, file: ProgressFile, questions: list[Question]) -> Row:
    predicted = [name in file.predictions for name in lesson.predictions]
    answered = [_is_right(file, question) for question in questions if question.lesson == lesson.name]
    try:
        exercises = [item for item in read_course(find_course('.')) if item.lesson == lesson.name]
    except UnusableInput:
        exercises = []
    tries = [file.exercises.get(item.name) for item in exercises]
    points = sum(item.best_points for item in tries if item)
    return Row(
        lesson.title,
        _of(predicted),
        _of(answered),
        _of([item is not None and item.done for item in tries]),
        f'{points} of {sum(item.points for item in exercises)}' if exercises else '',
    )


def _of(done: list[bool]) -> str:
    return f'{sum(done)} of {len(done)}' if done else ''


def _is_right(file: ProgressFile, question: Question) -> bool:
    return file.answers.get(question.name, [''])[-1] == question.right


def _to_repeat(file: ProgressFile, questions: list[Question]) -> list[str]:
    """Return what the student tried without success, first questions, then exercises."""
    asked = [f'quiz({item.name!r})' for item in questions if file.answers.get(item.name) and not _is_right(file, item)]
    tried = [f'check({name!r})' for name, item in file.exercises.items() if item.attempts and not item.done]
    return [*asked, *tried][:MOST_REPEATED]
