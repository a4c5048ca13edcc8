"""``edugrade export moodle|canvas RESULTS/`` exports the marks of a class, one for each student, for import into a platform.

Canvas imports its own gradebook with one more column (Canvas Guides, "How do I import grades in the Gradebook?"). The first
columns are Student, ID, SIS User ID, SIS Login ID and Section. The line "Points Possible" comes before the students.
Moodle imports CSV with a header, whose columns the teacher maps (docs.moodle.org, "Grade import"). It also imports the offline
grading worksheet of an assignment (docs.moodle.org, "Assignment: offline grading worksheet").
"""

from __future__ import annotations

import argparse
import csv
import io
from collections import Counter
from collections.abc import Sequence
from typing import Any, NamedTuple

from edulaunch.errors import UnusableInput

from ...files import read_regular, write_whole
from ..batch.store import Store
from ..batch.tables import confined_by, csv_text, first_problem, plain
from ..decisions import decided, read_late


class Mark(NamedTuple):
    """The points of a student, or None for no mark, with the possible points and the comment."""

    student: str
    id: str
    earned: float | None
    possible: int
    feedback: str


def marks_of(results: Sequence[dict[str, Any]], exercise: str | None = None) -> tuple[str, list[Mark]]:
    """Return the exercise and its marks. If a student has several submissions, the best submission counts.

    :param exercise: the name of the exercise; optional if all results belong to one exercise.
    :raises UnusableInput: when the exercise is not clear, or no student submitted it.
    """
    known = sorted({result['rubric']['name'] for result in results if 'rubric' in result})
    if exercise is None and len(known) == 1:
        exercise = known[0]
    if exercise is None or exercise not in known:
        raise UnusableInput(f'the results have the exercises {", ".join(known) or "(none)"}', help='add --exercise NAME')
    possible = max(result['points']['possible'] for result in results if result.get('rubric', {}).get('name') == exercise)
    best: dict[tuple[str, str], Mark] = {}
    for result in results:
        if result.get('rubric', {}).get('name', exercise) == exercise:
            mark = _mark(result, possible)
            other = best.get((mark.student, mark.id))
            if other is None or (mark.earned is not None and (other.earned is None or mark.earned > other.earned)):
                best[mark.student, mark.id] = mark
    return exercise, list(best.values())


def _mark(result: dict[str, Any], possible: int) -> Mark:
    earned = result.get('points', {}).get('earned')
    words = first_problem(result)
    feedback = 'All checks passed.' if words is None else words if earned is not None else f'Not graded: {words}'
    *first, last = [feedback, *remarks(result)]
    feedback = ' '.join([*map(sentence, first), last])
    return Mark(result['student'], result.get('student_id') or '', earned, possible, ' '.join(feedback.split()))


def sentence(text: str) -> str:
    """Return the string with the end of a sentence, so that another sentence can follow it."""
    text = text.rstrip()
    return text if text.endswith(('.', '!', '?')) else f'{text}.'


def remarks(result: dict[str, Any]) -> list[str]:
    """Return the comment on a mark: the teacher's comment, deductions, and layers of the sandbox that failed."""
    days, graded, earned = result.get('late_days', 0), result.get('graded'), result.get('points', {}).get('earned')
    sentences = [sentence(result['comment'])] if result.get('comment') else []
    if days:
        sentences.append(f'{days} {"day" if days == 1 else "days"} late.')
    if graded is not None:
        sentences.append(f'{earned:g} points count; the checks gave {graded:g}.')
    return [*sentences, f'Runs: {confined_by(result)}.'] if is_unconfined(result) else sentences


def is_unconfined(result: dict[str, Any]) -> bool:
    """Return whether a mark comes from runs that were not fully confined."""
    layers = result.get('sandbox') or {}
    return 'checks' in result and (not layers or any(state != 'held' for layer, state in layers.items() if layer != 'view'))


LARGEST_BYTES = 20_000_000


def read_list(path: str) -> tuple[list[str], list[dict[str, str]], str]:
    """Return the first row, the other rows, and the separator of the cells, which is a semicolon for spreadsheets in some
    languages.

    :raises UnusableInput: when the list cannot be read.
    """
    try:
        text = read_regular(path, LARGEST_BYTES).decode('utf-8-sig')
    except (OSError, UnicodeDecodeError) as error:
        raise UnusableInput(f'the list {path} cannot be read: {error}', help='save it as CSV in UTF-8') from None
    first = text.partition('\n')[0]
    separator = ';' if first.count(';') > first.count(',') else ','
    reader = csv.DictReader(io.StringIO(text), restval='', delimiter=separator)
    rows = [{key: value for key, value in row.items() if isinstance(key, str)} for row in reader]
    return list(reader.fieldnames or ()), rows, separator


def list_text(head: Sequence[str], rows: Sequence[dict[str, str]], separator: str) -> str:
    """Return the list as CSV, with its original columns and separator and the new values."""
    file = io.StringIO()
    writer = csv.DictWriter(file, head, lineterminator='\r\n', extrasaction='ignore', delimiter=separator)
    writer.writeheader()
    writer.writerows(rows)
    return file.getvalue()


def points(mark: Mark) -> str:
    """Return the points of a mark as a string, or '' without a mark."""
    return '' if mark.earned is None else f'{mark.earned:g}'


class People:
    """Finds the mark of a student by a number, or by a unique name. 'Lovelace, Ada' and 'Ada Lovelace' are the same name."""

    def __init__(self, marks: Sequence[Mark]) -> None:
        self._marks = marks
        self._met: set[tuple[str, str]] = set()
        names = Counter(_words(mark.student) for mark in marks)
        self._by_id = {mark.id: mark for mark in marks if mark.id}
        self._by_name = {_words(mark.student): mark for mark in marks if names[_words(mark.student)] == 1}

    def find(self, numbers: Sequence[str], name: str) -> Mark | None:
        """Return the mark of the student with one of these numbers, or with this name. Return None if no student matches."""
        found = next((self._by_id[number] for number in numbers if number in self._by_id), None)
        if found is None:
            found = self._by_name.get(_words(name))
        if found is not None:
            self._met.add((found.student, found.id))
        return found

    @property
    def unmet(self) -> list[str]:
        """Return the names of students that the platform's file does not list, with or without a mark."""
        return [mark.student for mark in self._marks if (mark.student, mark.id) not in self._met]


def _words(name: str) -> str:
    return ' '.join(sorted(name.casefold().replace(',', ' ').split()))


STUDENT, POSSIBLE = 'Student', 'Points Possible'
NUMBERS = ('ID', 'SIS User ID', 'SIS Login ID')
KEPT = (STUDENT, *NUMBERS, 'Section')


def canvas_csv(path: str, title: str, marks: Sequence[Mark]) -> tuple[str, list[str]]:
    """Return the gradebook with the marks in the column of that title, and the students who are not in the gradebook.

    The column may be new, or called ``title (1234)``. A student is found by the number that Canvas writes into the names of
    downloads, or by name. Other columns are left out, because Canvas would import them.

    :raises UnusableInput: when the file is not a gradebook of Canvas.
    """
    head, rows, separator = read_list(path)
    if not {STUDENT, 'ID', 'Section'} <= set(head):
        raise UnusableInput(f'{path} is not a gradebook of Canvas', help='export it there: Grades, Export')
    column = next((name for name in head if name == title or name.startswith(f'{title} (')), title)
    people, possible = People(marks), str(marks[0].possible if marks else '')
    kept = [{STUDENT: f'    {POSSIBLE}', column: possible}]
    for row in rows:
        if row[STUDENT].strip() == POSSIBLE:
            kept[0] = {**row, column: possible}
            continue
        mark = people.find([row[key] for key in NUMBERS if row.get(key)], row[STUDENT])
        if mark is not None:
            kept.append({**row, column: points(mark) or row.get(column, '')})
    return list_text([*(name for name in KEPT if name in head), column], kept, separator), people.unmet


IDENTIFIER, NAME, GRADE, FEEDBACK = 'Identifier', 'Full name', 'Grade', 'Feedback comments'
MAXIMUM = ('Maximum Grade', 'Maximum grade')


def moodle_csv(title: str, marks: Sequence[Mark], separator: str = ',') -> str:
    """Return the file for *Grades, Import, CSV file*: the name and number of each student, the mark, and feedback."""
    columns = (NAME, 'ID number', title, f'{title} (feedback)')
    lines = [dict(zip(columns, (mark.student, mark.id, points(mark), mark.feedback), strict=True)) for mark in marks]
    return csv_text(columns, lines, separator)


def moodle_worksheet(path: str, marks: Sequence[Mark]) -> tuple[str, list[str]]:
    """Return the worksheet with grades and feedback filled in, and the students that the worksheet does not name.

    A student is found by the number after "Participant", which is also in the names of downloads, or by name.

    :raises UnusableInput: when the file is not a worksheet, or its maximum grade differs from the points of the exercise.
    """
    head, rows, separator = read_list(path)
    lacking = [name for name in (IDENTIFIER, NAME, GRADE) if name not in head]
    if lacking:
        raise UnusableInput(
            f'{path} is not a grading worksheet: it has no column {lacking[0]}', help='download it in Moodle, in English'
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
    return list_text(head, rows, separator), people.unmet


def table_csv(results: Sequence[dict[str, Any]], separator: str = ',') -> str:
    """Return a CSV table with one line for each student and the points of every exercise. A missing mark is an empty cell."""
    exercises = sorted({result['rubric']['name'] for result in results if 'rubric' in result})
    marks = {name: {(mark.student, mark.id): mark for mark in marks_of(results, name)[1]} for name in exercises}
    possible = sum(next(iter(found.values())).possible for found in marks.values())
    people = dict.fromkeys((result['student'], result.get('student_id') or '') for result in results)
    lines = []
    for person in people:
        own = [result for result in results if (result['student'], result.get('student_id') or '') == person]
        found = {name: marks[name][person] for name in exercises if person in marks[name]}
        line = {'student': person[0], 'student_id': person[1], **{name: points(mark) for name, mark in found.items()}}
        line['points'] = f'{sum(mark.earned or 0 for mark in found.values()):g}'
        line['possible'] = str(possible)
        line['without_mark'] = ' '.join(name for name, mark in found.items() if mark.earned is None)
        line['remarks'] = ' '.join(dict.fromkeys(remark for result in own for remark in remarks(result)))
        line['sandbox'] = ' | '.join(dict.fromkeys(filter(None, map(confined_by, own))))
        lines.append(line)
    head = ('student', 'student_id', *exercises, 'points', 'possible', 'without_mark', 'remarks', 'sandbox')
    return csv_text(head, [{name: line.get(name, '') for name in head} for line in lines], separator)


def _is(text: str, number: int) -> bool:
    try:
        return float(text.replace(',', '.')) == number
    except ValueError:
        return False


def export_parser() -> argparse.ArgumentParser:
    """Return the parser of the words after ``edugrade export``."""
    parser = argparse.ArgumentParser(
        prog='edugrade export',
        description='Write the marks of a batch for a learning platform. A submission without a mark has an empty cell.',
    )
    parser.add_argument('format', choices=('moodle', 'canvas', 'table'), help='table: all exercises, one line for each student')
    parser.add_argument('results', metavar='RESULTS', help='the folder that edugrade batch has written')
    parser.add_argument('--out', metavar='FILE', required=True, help='the table to write')
    parser.add_argument('--exercise', metavar='NAME', help='the exercise (required if the results have several)')
    parser.add_argument(
        '--list',
        metavar='FILE',
        help="the platform's own file, to be filled in: Moodle's offline grading worksheet, or the gradebook of Canvas",
    )
    parser.add_argument('--title', metavar='TEXT', help='name of the column (default: the exercise)')
    parser.add_argument('--separator', choices=(',', ';'), metavar='CHARACTER', default=',', help='comma (default) or semicolon')
    parser.add_argument('--due', metavar='TIME', help='the due date, such as 2026-11-20T23:59; each later day costs points')
    parser.add_argument('--late-per-day', type=float, default=10.0, metavar='PERCENT', help='for each late day (default: 10)')
    parser.add_argument('--submitted', metavar='FILE', help='a table with the times of submission: student,submitted')
    return parser


def main(words: Sequence[str]) -> int:
    """Run the command. Name the students who are missing from the list of the platform."""
    options = export_parser().parse_args(words)
    if (options.due is None) != (options.submitted is None):
        raise UnusableInput('--due needs --submitted, and the reverse', help='write --submitted FILE with student,submitted')
    late = read_late(options.due, options.late_per_day, options.submitted) if options.due else None
    results = decided(Store(options.results).all(), options.results, late)
    unconfined = sum(map(is_unconfined, results))
    if unconfined:
        print(f'{unconfined} of these marks come from runs without a complete sandbox')
    if options.format == 'table':
        write_whole(options.out, table_csv(results, options.separator))
        print(f'all exercises: {options.out}')
        return 0
    exercise, marks = marks_of(results, options.exercise)
    title = options.title or exercise
    if options.format == 'canvas':
        if options.list is None:
            raise UnusableInput(
                'Canvas imports its own gradebook only', help='export it there (Grades, Export), and give --list FILE'
            )
        text, unknown = canvas_csv(options.list, title, marks)
    elif options.list is not None:
        text, unknown = moodle_worksheet(options.list, marks)
    else:
        text, unknown = moodle_csv(title, marks, options.separator), []
    write_whole(options.out, text)
    without = sum(mark.earned is None for mark in marks)
    print(f'{len(marks) - without} marks of {exercise} for {len(marks)} students: {options.out}')
    if unknown:
        print('not in the list: ' + ', '.join(unknown))
    return 1 if unknown else 0
