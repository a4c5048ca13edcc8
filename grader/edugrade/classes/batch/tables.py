"""Writes the results of a class: a table for spreadsheets, a page for the class, and a page for each student."""

from __future__ import annotations

import csv
import io
import os
import re
from collections import Counter
from collections.abc import Iterator, Sequence
from hashlib import sha256
from typing import TYPE_CHECKING
from urllib.parse import quote

from ...files import write_whole
from ...reports.markup import Markup, element, html_page, table_row
from ...reports.theme import PAGE
from ...results import BROKEN_GRADER, OWN_VARIANT

if TYPE_CHECKING:
    from .store import Store

if TYPE_CHECKING:
    from .entries import Entry
    from .store import Result

    Results = Sequence[tuple[Entry, Result | None]]

COLUMNS = (
    *('student', 'student_id', 'submission', 'exercise', 'verdict', 'earned', 'possible', 'first_problem'),
    *('sha256', 'seed', 'origin', 'sandbox', 'run_s', 'graded', 'comment'),
)
FORMULA = ('=', '+', '-', '@', '\t', '\r')
BEHIND_A_SEPARATOR = re.compile(r'([;|\t\n][ "]*)(?=[=+@-])')
BEHIND_A_COMMA = re.compile(r'(,[ "]*)(?=[=+@-])')
"""The places at which a spreadsheet with other separators would begin a cell with a formula."""


NUMBER = re.compile(r'^(\d+)\.(\d+)$')


def rows(results: Results) -> list[dict[str, str]]:
    """Return a row for each submission. A missing mark is an empty string, never a zero."""
    return [_row(entry, found or {'refused': 'not graded yet'}) for entry, found in results]


def _row(entry: Entry, found: Result) -> dict[str, str]:
    points, made = found.get('points', {}), found.get('receipt') or {}
    is_copied = any(check['name'] == OWN_VARIANT for check in found.get('checks', ()))
    values = {
        'student': entry.student,
        'student_id': entry.id,
        'submission': entry.path,
        'exercise': found.get('rubric', {}).get('name'),
        'verdict': found.get('verdict') if 'checks' in found and not is_copied else 'not graded',
        'earned': points.get('earned'),
        'possible': points.get('possible'),
        'first_problem': first_problem(found),
        'sha256': made.get('submission'),
        'seed': made.get('seed'),
        'origin': entry.origin,
        'sandbox': confined_by(found),
        'run_s': found.get('run_s'),
        'graded': found.get('graded'),
        'comment': found.get('comment'),
    }
    return {name: '' if value is None else str(value) for name, value in values.items()}


def confined_by(found: Result) -> str:
    """Return the layers of the sandbox that confined the runs of a submission, and the layers that failed, with the reason."""
    layers = found.get('sandbox') or {}
    if 'checks' not in found or (not layers and found.get('exit_code') == BROKEN_GRADER):
        return ''
    missing = [f'{layer} ({state})' for layer, state in layers.items() if state != 'held']
    held = [layer for layer, state in layers.items() if state == 'held']
    return (', '.join(held) or 'not confined') + (f'; without {", ".join(missing)}' if missing else '')


def one_line(text: str) -> str:
    """Return the first line of a string. If it ends in a colon, append the second line.

    For a list of exceptions, return only the second line.
    """
    lines = [line.strip().removeprefix('- ') for line in text.splitlines() if line.strip()]
    if lines[1:] and lines[0].endswith(':'):
        return lines[1] if lines[0].startswith('Caught ') else f'{lines[0]} {lines[1]}'
    return lines[0] if lines else ''


def first_problem(found: Result) -> str | None:
    """Return in one line why the submission was not graded, or why its first failed check did not pass. Return None if all
    checks passed.
    """
    broken = next((check for check in found.get('checks', ()) if check['status'] not in ('passed', 'not_run')), None)
    words = found.get('refused') or (broken and broken['reason'])
    return one_line(words) if words else None


def class_csv(results: Results) -> str:
    """Return a CSV table with one line for each submission."""
    return csv_text(COLUMNS, rows(results))


def csv_text(columns: Sequence[str], lines: Sequence[dict[str, str]], separator: str = ',') -> str:
    """Return a table as CSV. An apostrophe precedes every string that a spreadsheet could read as a formula. An apostrophe is
    also added after any other separator of cells within the string.

    :param separator: the separator of the cells. With a semicolon, numbers have a decimal comma, because such a spreadsheet reads
        9.6 as a date.
    """
    file = io.StringIO()
    writer = csv.DictWriter(file, columns, lineterminator='\n', delimiter=separator)
    writer.writeheader()
    for line in lines:
        cells = {name: plain(value) for name, value in line.items()}
        if separator == ';':
            cells = {name: NUMBER.sub(r'\1,\2', BEHIND_A_COMMA.sub(r"\1'", value)) for name, value in cells.items()}
        writer.writerow(cells)
    return file.getvalue()


def plain(value: str) -> str:
    """Return the string in a form that a spreadsheet shows and never evaluates."""
    value = ''.join(sign if sign.isprintable() or sign in '\n\t' else '?' for sign in value)
    value = BEHIND_A_SEPARATOR.sub(r"\1'", value)
    return f"'{value}" if value.startswith(FORMULA) else value


STYLE = PAGE + (
    'body{font:16px/1.45 system-ui,sans-serif;margin:2em}'
    'table{display:block;overflow-x:auto}a,td:last-child{overflow-wrap:anywhere}td:last-child{min-width:12em}'
    'table{border-collapse:collapse}tr+tr{border-top:1px solid var(--line)}'
    'td,th{text-align:left;vertical-align:top;padding:.2em 1.2em .2em 0}'
)
SHOWN = {
    'exercise': 'exercise',
    'verdict': 'outcome',
    'earned': 'earned',
    'possible': 'possible',
    'sandbox': 'sandbox',
    'first_problem': 'first problem',
}
"""The columns of the table that the class page has, with their headings."""
MOST_CAUSES = 20
LONGEST_STEM = 80  # characters in the name of a student's page


def write_pages(folder: str, results: Results, store: Store) -> None:
    """Write ``index.html`` and ``students/*.html``. They link to the pages of the submissions, which already exist."""
    os.makedirs(os.path.join(folder, 'students'), exist_ok=True)
    pages = {entry.path: os.path.relpath(store.path(entry, '.html', folder), folder) for entry, _ in results}
    pages = {path: page for path, page in pages.items() if os.path.exists(os.path.join(folder, page))}
    for student in dict.fromkeys((entry.student, entry.id) for entry, _ in results):
        own = [(entry, found) for entry, found in results if (entry.student, entry.id) == student]
        write_whole(os.path.join(folder, student_file(*student)), student_page(student[0], own, pages))
    write_whole(os.path.join(folder, 'index.html'), class_page(results, pages))


def student_file(name: str, number: str = '') -> str:
    """Return the path of a student's page. The path is readable and unique."""
    readable = ''.join(sign if sign.isalnum() else '_' for sign in name)[:LONGEST_STEM]
    return f'students/{readable}-{sha256(f"{name}/{number}".encode("utf-8", "surrogateescape")).hexdigest()[:8]}.html'


def class_page(results: Results, pages: dict[str, str]) -> str:
    """Return the page with all marks, the most frequent problems, and the numbers of passes and failures of each check."""
    table = [table_row('student', 'submission', *SHOWN.values(), kind='th')]
    for (entry, found), row in zip(results, rows(results), strict=True):
        if found and set((found.get('sandbox') or {}).values()) == {'held'}:
            row['sandbox'] = 'complete'
        name = element('a', entry.student, href=quote(student_file(entry.student, entry.id)))
        table.append(table_row(name, _link(entry.path, pages), *(row[column] for column in SHOWN)))
    return html_page(
        'edugrade: Marks of the class',
        STYLE,
        element('h1', 'Marks of the class'),
        *(element('p', words) for words in _marks(results)),
        element('table', *table),
        element('h2', 'Most common causes'),
        element('table', *_causes(results)),
        element('h2', 'Checks'),
        element('table', *_checks(results)),
    )


def student_page(name: str, results: Results, pages: dict[str, str]) -> str:
    """Return the page with one student's submissions, check by check."""
    parts: list[Markup] = []
    for (entry, found), row in zip(results, rows(results), strict=True):
        mark = f': {row["earned"]} of {row["possible"]} points' if row['earned'] else ': no mark'
        parts.append(element('h2', (row['exercise'] or entry.path) + mark))
        parts.append(element('p', _link(entry.path, {path: f'../{page}' for path, page in pages.items()}), f' {row["verdict"]}'))
        if row['first_problem'] and 'checks' not in (found or {}):
            parts.append(element('p', f'{row["first_problem"]}. {(found or {}).get("help") or ""}'))
        checks = [table_row('check', 'result', 'points', 'why', 'seen', 'try', kind='th')]
        for check in (found or {}).get('checks', ()):
            words = (check['reason'], check['seen'], check['try'])
            points = f'{check["earned"]} of {check["points"]}' if check['points'] else ''
            checks.append(
                table_row(check['sentence'], check['status'].replace('_', ' '), points, *(word or '' for word in words))
            )
        parts += [element('table', *checks)] if len(checks) > 1 else []
    return html_page(f'edugrade: {name}', STYLE, element('h1', name), *parts)


def _marks(results: Results) -> Iterator[str]:
    """Yield the number of marks of each exercise, with the range, median and mean of these marks."""
    marks: dict[str, list[float]] = {}
    for _, found in results:
        if found and found.get('points', {}).get('earned') is not None:
            marks.setdefault(f'{found["rubric"]["name"]} (of {found["points"]["possible"]})', []).append(
                found['points']['earned']
            )
    for exercise, given in sorted(marks.items()):
        given.sort()
        median = (given[(len(given) - 1) // 2] + given[len(given) // 2]) / 2
        mean, count = sum(given) / len(given), f'{len(given)} mark{"s"[: len(given) > 1]}'
        yield f'{exercise}: {count}, {given[0]} to {given[-1]}, median {median:g}, mean {mean:.1f}.'
    without = sum(1 for _, found in results if not found or found.get('points', {}).get('earned') is None)
    if without:
        yield f'{without} submissions could not be graded. They have no mark, which differs from zero points.'


def _causes(results: Results) -> list[Markup]:
    """Return the first problems of the submissions, the most frequent problem first."""
    counts: Counter[tuple[str, str, str]] = Counter()
    for (_, found), row in zip(results, rows(results), strict=True):
        if row['first_problem']:
            bad = next(
                (check for check in (found or {}).get('checks', ()) if check['status'] in ('failed', 'grader_broke')), None
            )
            counts[row['exercise'], bad['sentence'] if bad else 'The submission can be graded', row['first_problem']] += 1
    lines = [table_row('submissions', 'exercise', 'check', 'cause', kind='th')]
    lines += [table_row(str(count), *cause) for cause, count in sorted(counts.items(), key=lambda item: (-item[1], item[0]))]
    return lines[: MOST_CAUSES + 1]


def _checks(results: Results) -> list[Markup]:
    counts: dict[tuple[str, str], Counter[str]] = {}
    for _, found in results:
        for check in (found or {}).get('checks', ()):
            counts.setdefault((found['rubric']['name'], check['sentence']), Counter())[check['status']] += 1  # type: ignore[index]
    lines = [table_row('exercise', 'check', 'passed', 'failed', 'not run', kind='th')]
    for (exercise, sentence), of in counts.items():
        lines.append(table_row(exercise, sentence, *(str(of[status]) for status in ('passed', 'failed', 'not_run'))))
    return lines


def _link(path: str, pages: dict[str, str]) -> str:
    return element('a', path, href=quote(pages[path], errors='surrogateescape')) if path in pages else path
