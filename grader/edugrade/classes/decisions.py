"""A teacher's decisions on the results of a batch: other points, comments, and deductions for late submissions.

The file ``teacher.csv`` in the directory of the results contains the points and comments. Grading never writes this file, so the
decisions remain after the next grading.
"""

from __future__ import annotations

import csv
import io
import os
from collections.abc import Collection, Mapping, Sequence
from datetime import datetime
from math import ceil, isfinite
from typing import Any, NamedTuple

from edulaunch.engine.nearest import nearest
from edulaunch.errors import UnusableInput

from ..files import read_given

FILE = 'teacher.csv'
LARGEST_BYTES = 5_000_000
COLUMNS = ('student', 'exercise', 'points', 'comment')
NAMES, NUMBERS = ('student', 'Student', 'Full name', 'Name'), ('student_id', 'id', 'Identifier', 'SID')
TIMES = ('submitted', 'Submission Time', 'Last modified (submission)')
MOODLE_TIME = '%A, %d %B %Y, %I:%M %p'
DAY_S = 86400

Result = dict[str, Any]


class Decision(NamedTuple):
    """The points that a teacher gives, and a comment. None as points means the points of the grader."""

    points: float | None
    comment: str


class Late(NamedTuple):
    """The deduction for late submissions: `per_day` percent of the points for each started day after `due`."""

    due: datetime
    per_day: float
    submitted: Mapping[str, datetime]

    def days(self, result: Result) -> int:
        """Return the number of days that a submission is late, or 0 when the time of submission is unknown."""
        when = self.submitted.get(str(result.get('student_id') or '')) or self.submitted.get(str(result['student']))
        if when is None:
            return 0
        try:
            return max(0, ceil((when - self.due).total_seconds() / DAY_S))
        except TypeError:
            raise UnusableInput(
                'only one of the due date and the times of submission has a time zone',
                help='write both with a time zone, such as --due 2026-11-20T23:59+01:00',
            ) from None


def decided(results: Sequence[Result], folder: str, late: Late | None = None) -> list[Result]:
    """Return the results with the points that count.

    If a teacher's decision or a deduction changes the points, `graded` has the points of the grader, and `comment` and
    `late_days` give the reason.

    :param folder: the folder of the results.
    :raises UnusableInput: when the teacher's file cannot be read, or names a student without a result.
    """
    decisions = read_decisions(os.path.join(folder, FILE))
    found = [_decided(result, decisions, late) for result in results]
    known = {key for result in results for key in _keys(result)}
    for name, exercise in decisions:
        if (name, exercise) not in known:
            _refuse_stranger(folder, name, {student for student, _ in known})
            has = sorted(other for student, other in known if student == name and other)
            raise UnusableInput(
                f'{os.path.join(folder, FILE)}: {name} has no result of {exercise}', help=f'write one of {", ".join(has)}'
            )
    return found


def refuse_strangers(folder: str, names: Collection[str]) -> None:
    """Check the teacher's file before a class is graded.

    :param folder: the folder of the results.
    :param names: the names and numbers of the students.
    :raises UnusableInput: when the file cannot be read, or names another student.
    """
    for name, _ in read_decisions(os.path.join(folder, FILE)):
        _refuse_stranger(folder, name, names)


def _refuse_stranger(folder: str, name: str, names: Collection[str]) -> None:
    if name not in names:
        close = nearest(name, names)
        help = f'write {close}, or remove the line' if close else 'write the name as in the table of marks, or remove the line'
        raise UnusableInput(f'{os.path.join(folder, FILE)} names {name}, who has no result', help=help)


def _keys(result: Result) -> list[tuple[str, str]]:
    names = [name for name in (result['student'], result.get('student_id')) if name]
    return [(name, exercise) for name in names for exercise in (result.get('rubric', {}).get('name', ''), '')]


def _decided(result: Result, decisions: Mapping[tuple[str, str], Decision], late: Late | None) -> Result:
    decision = next((decisions[key] for key in _keys(result) if key in decisions), Decision(None, ''))
    points = result.get('points', {})
    earned, days = points.get('earned'), late.days(result) if late else 0
    counted = earned if decision.points is None else decision.points
    if counted is not None and late is not None and decision.points is None:
        counted = round(counted * max(0.0, 1 - late.per_day / 100 * days), 2)
    about: Result = {'comment': decision.comment} if decision.comment else {}
    about |= {'late_days': days} if days else {}
    if counted == earned:
        return {**result, **about}
    return {**result, **about, 'graded': earned, 'points': {**points, 'earned': counted, 'possible': points.get('possible', 0)}}


def read_decisions(path: str) -> dict[tuple[str, str], Decision]:
    """Return the rows of the teacher's file, by student (name or number) and exercise. Without such a file, the result is empty.

    :raises UnusableInput: when the columns are missing or a line is invalid. The message contains the number of the line.
    """
    if not os.path.exists(path):
        return {}
    head, rows = read_table(path)
    if not {'student', 'points'} <= set(head):
        raise UnusableInput(f'{path} has no columns student and points', help=f'write this first line: {",".join(COLUMNS)}')
    found = {}
    for number, row in enumerate(rows, 2):
        text = row['points'].strip().replace(',', '.')
        try:
            points = float(text) if text else None
        except ValueError:
            points = -1.0
        if points is not None and not (isfinite(points) and points >= 0):
            raise UnusableInput(
                f'{path}:{number}: {row["points"]!r} is not a valid number of points',
                help='write a number, or leave the cell empty to keep the points of the grader',
            )
        if row['student'].strip():
            found[row['student'].strip(), row.get('exercise', '').strip()] = Decision(points, row.get('comment', '').strip())
    return found


def read_late(due: str, per_day: float, path: str) -> Late:
    """Return the deduction with the times of submission from a table of edulaunch (``student,submitted``) or of Gradescope, or
    from a worksheet of Moodle.

    :param due: the time after which submissions are late, in ISO 8601.
    :param per_day: the percent of the points to deduct for each started day, from 0 to 100.
    :param path: the path of the table.
    :raises UnusableInput: when a time or `per_day` is invalid, or the table has no columns with students and times.
    """
    if not 0 <= per_day <= 100:
        raise UnusableInput(f'--late-per-day {per_day:g} is not a number from 0 to 100')
    head, rows = read_table(path)
    column = next((name for name in TIMES if name in head), None)
    if column is None or not set(head) & {*NAMES, *NUMBERS}:
        raise UnusableInput(
            f'{path} has no columns with students and times', help='begin the file with the line student,submitted'
        )
    times = {}
    for number, row in enumerate(rows, 2):
        if row[column].strip() not in ('', '-'):
            when = _time(row[column].strip(), f'{path}:{number}')
            for name in (*NAMES, *NUMBERS):
                if row.get(name, '').strip():
                    times[row[name].split()[-1] if name == 'Identifier' else row[name].strip()] = when
    return Late(_time(due, '--due'), per_day, times)


def _time(text: str, place: str) -> datetime:
    try:
        return datetime.fromisoformat(text.replace('Z', '+00:00').replace(' +', '+'))
    except ValueError:
        pass
    try:
        return datetime.strptime(text, MOODLE_TIME)
    except ValueError:
        raise UnusableInput(f'{place}: {text!r} is not a valid time', help='write, for example, 2026-11-20T23:59') from None


def read_table(path: str) -> tuple[list[str], list[dict[str, str]]]:
    """Return the first row and the other rows of a CSV file with commas or semicolons.

    :raises UnusableInput: when the file cannot be read.
    """
    try:
        text = read_given(path, LARGEST_BYTES, 'the table ').decode('utf-8-sig')
    except UnicodeDecodeError as error:
        raise UnusableInput(f'the table {path} cannot be read: {error}', help='save it as CSV in UTF-8') from None
    first = text.partition('\n')[0]
    reader = csv.DictReader(io.StringIO(text), restval='', delimiter=';' if first.count(';') > first.count(',') else ',')
    rows = [{key: value for key, value in row.items() if isinstance(key, str)} for row in reader]
    return list(reader.fieldnames or ()), rows
