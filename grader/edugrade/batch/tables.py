"""The results of a class as a table: CSV for a spreadsheet or a learning platform."""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .entries import Entry
    from .store import Result

    Results = Sequence[tuple[Entry, Result | None]]

COLUMNS = (
    *('student', 'student_id', 'submission', 'exercise', 'verdict', 'earned', 'possible', 'first_problem'),
    *('sha256', 'seed', 'origin'),
)
FORMULA = ('=', '+', '-', '@', '\t', '\r')


def rows(results: Results) -> list[dict[str, str]]:
    """A row for each submission: no mark is an empty text, and never a zero."""
    return [_row(entry, found or {'refused': 'not graded yet'}) for entry, found in results]


def _row(entry: Entry, found: Result) -> dict[str, str]:
    points, made = found.get('points', {}), found.get('receipt') or {}
    values = {
        'student': entry.student,
        'student_id': entry.id,
        'submission': entry.path,
        'exercise': found.get('rubric', {}).get('name'),
        'verdict': found.get('verdict') if 'checks' in found else 'not graded',
        'earned': points.get('earned'),
        'possible': points.get('possible'),
        'first_problem': first_problem(found),
        'sha256': made.get('submission'),
        'seed': made.get('seed'),
        'origin': entry.origin,
    }
    return {name: '' if value is None else str(value) for name, value in values.items()}


def first_problem(found: Result) -> str | None:
    """Why it was not graded, or why the first check that was run did not pass."""
    broken = next((check for check in found.get('checks', ()) if check['status'] not in ('passed', 'not_run')), None)
    return found.get('refused') or (broken and broken['reason'])


def class_csv(results: Results) -> str:
    """One line for each submission."""
    return csv_text(COLUMNS, rows(results))


def csv_text(columns: Sequence[str], lines: Sequence[dict[str, str]]) -> str:
    """A table. A text that a spreadsheet would take for a formula begins with an apostrophe; controls are question marks."""
    file = io.StringIO()
    writer = csv.DictWriter(file, columns, lineterminator='\n')
    writer.writeheader()
    for line in lines:
        writer.writerow({name: plain(value) for name, value in line.items()})
    return file.getvalue()


def plain(value: str) -> str:
    """A text as a spreadsheet shows it, and never runs it."""
    value = ''.join(sign if sign.isprintable() or sign in '\n\t' else '?' for sign in value)
    return f"'{value}" if value.startswith(FORMULA) else value
