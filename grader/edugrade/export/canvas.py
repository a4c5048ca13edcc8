"""Marks for Canvas: its own gradebook with a column more (Canvas Guides, "How do I import grades in the Gradebook?").

The first columns are Student, ID, SIS User ID, SIS Login ID, Section; the line "Points Possible" stands before the students.
"""

from __future__ import annotations

from collections.abc import Sequence

from edulaunch.errors import UnusableInput

from .lists import People, list_text, points, read_list
from .marks import Mark

STUDENT, POSSIBLE = 'Student', 'Points Possible'
NUMBERS = ('ID', 'SIS User ID', 'SIS Login ID')
KEPT = (STUDENT, *NUMBERS, 'Section')


def canvas_csv(path: str, title: str, marks: Sequence[Mark]) -> tuple[str, list[str]]:
    """The gradebook with the marks in the column of that title (a new one, or one called ``title (1234)``), and who is not in it.

    Students are known by a number (which Canvas writes into the names of downloads), else by their name. Other columns are left
    out: Canvas changes what a file has.

    :raises UnusableInput: when it is no gradebook of Canvas.
    """
    head, rows = read_list(path)
    if not {STUDENT, 'ID', 'Section'} <= set(head):
        raise UnusableInput(f'{path} is no gradebook of Canvas', help='export it there: Grades, Export')
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
    return list_text([*(name for name in KEPT if name in head), column], kept), people.unmet
