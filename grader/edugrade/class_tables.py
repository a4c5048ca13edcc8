"""The results of a class as a table: CSV for a spreadsheet or a learning platform, and a page."""

from __future__ import annotations

import csv
import io
from collections import Counter
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any
from urllib.parse import quote

from .markup import Markup, element

if TYPE_CHECKING:
    from .batch import Entry

    Results = Sequence[tuple[Entry, dict[str, Any] | None]]

COLUMNS = ('student', 'submission', 'exercise', 'verdict', 'earned', 'possible', 'first_problem', 'sha256', 'seed')
STYLE = 'body{font:16px/1.45 system-ui,sans-serif;margin:2em;color:#222}td,th{text-align:left;padding:.2em 1.2em .2em 0}'
POLICY = "default-src 'none'; style-src 'unsafe-inline'"


def rows(results: Results) -> list[dict[str, str]]:
    """A row for each submission: no mark is an empty text, and never a zero."""
    return [_row(entry, found or {'refused': 'not graded yet'}) for entry, found in results]


def _row(entry: Entry, found: dict[str, Any]) -> dict[str, str]:
    points, origin = found.get('points', {}), found.get('made_from') or {}
    broken = next((check for check in found.get('checks', ()) if check['status'] not in ('passed', 'not_run')), None)
    values = {
        'student': entry.student,
        'submission': entry.path,
        'exercise': found.get('rubric', {}).get('name'),
        'verdict': found.get('verdict') or 'not graded',
        'earned': points.get('earned'),
        'possible': points.get('possible'),
        'first_problem': found.get('refused') or (broken and broken['reason']),
        'sha256': origin.get('submission'),
        'seed': origin.get('seed'),
    }
    return {name: '' if value is None else str(value) for name, value in values.items()}


def class_csv(results: Results) -> str:
    """One line for each submission. A text that a spreadsheet would take for a formula begins with an apostrophe."""
    file = io.StringIO()
    writer = csv.DictWriter(file, COLUMNS, lineterminator='\n')
    writer.writeheader()
    for row in rows(results):
        writer.writerow(
            {name: f"'{value}" if value.startswith(('=', '+', '-', '@', '\t', '\r')) else value for name, value in row.items()}
        )
    return file.getvalue()


def class_page(results: Results) -> str:
    """All marks with links to the pages of the submissions, and how often each check passed and failed."""
    table = [_line('th', *COLUMNS[:7])]
    for row in rows(results):
        link = element('a', row['submission'], href=quote(f'{row["submission"]}.html'))
        table.append(_line('td', row['student'], link, *(row[name] for name in COLUMNS[2:7])))
    head = element(
        'head',
        element('meta', charset='utf-8'),
        element('meta', http_equiv='Content-Security-Policy', content=POLICY),
        element('title', 'edugrade: a class'),
        element('style', Markup(STYLE)),
    )
    parts = [element('h1', 'A class'), element('table', *table), element('h2', 'Checks'), element('table', *_checks(results))]
    return f'<!doctype html>\n{element("html", head, element("body", *parts), lang="en")}\n'


def _checks(results: Results) -> list[Markup]:
    counts: dict[tuple[str, str], Counter[str]] = {}
    for _, found in results:
        for check in (found or {}).get('checks', ()):
            counts.setdefault((found['rubric']['name'], check['sentence']), Counter())[check['status']] += 1  # type: ignore[index]
    lines = [_line('th', 'exercise', 'check', 'passed', 'failed', 'not run')]
    for (exercise, sentence), of in sorted(counts.items()):
        lines.append(_line('td', exercise, sentence, *(str(of[status]) for status in ('passed', 'failed', 'not_run'))))
    return lines


def _line(kind: str, *cells: str) -> Markup:
    return element('tr', *(element(kind, cell) for cell in cells))
