"""Marks for Moodle: the grade import (docs.moodle.org, "Grade import": CSV with a head, mapped by hand) and the offline grading
worksheet of an assignment (docs.moodle.org, "Assignment: offline grading worksheet").
"""

from __future__ import annotations

from collections.abc import Sequence

from edulaunch.errors import UnusableInput

from ..batch.tables import csv_text, plain
from .lists import People, list_text, points, read_list
from .marks import Mark

IDENTIFIER, NAME, GRADE, FEEDBACK = 'Identifier', 'Full name', 'Grade', 'Feedback comments'
MAXIMUM = ('Maximum Grade', 'Maximum grade')


def moodle_csv(title: str, marks: Sequence[Mark]) -> str:
    """For *Grades, Import, CSV file*: students by their names (and numbers), the mark, feedback."""
    columns = (NAME, 'ID number', title, f'{title} (feedback)')
    lines = [dict(zip(columns, (mark.student, mark.id, points(mark), mark.feedback), strict=True)) for mark in marks]
    return csv_text(columns, lines)


def moodle_worksheet(path: str, marks: Sequence[Mark]) -> tuple[str, list[str]]:
    """The worksheet with grades and feedback filled in, and the students that it does not name.

    Students are known by the number behind "Participant", which the names of downloads have too, else by their name.

    :raises UnusableInput: when it is no worksheet, or its maximum is not that of the exercise.
    """
    head, rows = read_list(path)
    lacking = [name for name in (IDENTIFIER, NAME, GRADE) if name not in head]
    if lacking:
        raise UnusableInput(
            f'{path} is no grading worksheet: it has no column {lacking[0]}', help='download it in Moodle, in English'
        )
    people = People(marks)
    for row in rows:
        mark = people.find(row[IDENTIFIER].split()[-1:], row[NAME])
        if mark is None:
            continue
        maximum = next((row[name] for name in MAXIMUM if row.get(name)), '')
        if maximum and not _is(maximum, mark.possible):
            words = f'the worksheet is out of {maximum}, the exercise out of {mark.possible}'
            raise UnusableInput(words, help='set the maximum grade of the assignment in Moodle')
        row[GRADE] = points(mark) or row[GRADE]
        if FEEDBACK in head:
            row[FEEDBACK] = plain(mark.feedback)
    return list_text(head, rows), people.unmet


def _is(text: str, number: int) -> bool:
    try:
        return float(text.replace(',', '.')) == number
    except ValueError:
        return False
