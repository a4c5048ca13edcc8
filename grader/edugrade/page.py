"""The page of ``--html``: reports with the pictures and replays of their runs, in one file that needs no network."""

from __future__ import annotations

from collections.abc import Sequence

from .markup import Markup, element
from .report_html import COLOURS, report_html
from .results import FAILED, PASSED, Refusal, Report
from .run_html import run_html
from .short_paths import ShortPaths

POLICY = "default-src 'none'; style-src 'unsafe-inline'; img-src data:; script-src 'unsafe-inline'"
STYLE = """
body { font: 16px/1.45 system-ui, sans-serif; max-width: 62em; margin: 2em auto; padding: 0 1em; color: #222; }
h1 { font-size: 1.5em; } h2 { font-size: 1.25em; margin: 2em 0 .2em; }
table.sum { border-collapse: collapse; } table.sum th, table.sum td { text-align: left; padding: .2em 1.2em .2em 0; }
table.sum tr + tr { border-top: 1px solid #ddd; }
details { margin: .6em 0; } summary { cursor: pointer; } figure { margin: .5em 0; }
img { max-width: min(100%, 36em); } figcaption, .small { font-size: .85em; color: #555; }
@media print { iframe { display: none; } }
"""


def page(reports: Sequence[Report], refusals: Sequence[Refusal]) -> str:
    """The whole page. Nothing that a student wrote is markup in it, and the browser is told to load nothing."""
    parts = [_summary(reports, refusals)] if len(reports) + len(refusals) > 1 else []
    parts += [_section(report, number) for number, report in enumerate(reports)]
    parts += [_refused(refusal) for refusal in refusals]
    head = element(
        'head',
        element('meta', charset='utf-8'),
        element('meta', http_equiv='Content-Security-Policy', content=POLICY),
        element('meta', name='viewport', content='width=device-width, initial-scale=1'),
        element('title', 'edugrade report'),
        element('style', Markup(STYLE)),
    )
    body = element('body', element('h1', 'edugrade report'), *parts)
    return f'<!doctype html>\n{element("html", head, body, lang="en")}\n'


def _summary(reports: Sequence[Report], refusals: Sequence[Refusal]) -> Markup:
    rows = [element('tr', *(element('th', name) for name in ('submission', 'result', 'checks', 'points')))]
    for number, report in enumerate(reports):
        mark = 'no mark' if report.earned is None else f'{report.earned} of {report.possible}'
        link = element('a', report.given, href=f'#r{number}')
        rows.append(_row(link, _verdict(report), f'{report.passed} of {len(report.results)}', mark))
    rows += [_row(refusal.given, 'refused', '-', '-') for refusal in refusals]
    return element('table', *rows, class_='sum')


def _row(*cells: str) -> Markup:
    return element('tr', *(element('td', cell) for cell in cells))


def _verdict(report: Report) -> Markup:
    return element('b', report.verdict, style=f'color:{COLOURS[FAILED if report.exit_code else PASSED]}')


def _section(report: Report, number: int) -> Markup:
    paths = ShortPaths(report.folder, report.shown, report.package)
    outcomes = [outcome._replace(text=paths.text(outcome.text) or '') for outcome in report.outcomes]
    return element(
        'section',
        element('h2', report.title),
        element(
            'p',
            f'{report.given}: ',
            _verdict(report),
            f' (rubric {report.rubric}, seed {report.seed}, text {report.sha256[:12]})',
            class_='small',
        ),
        report_html(report),
        *(run_html(outcome, is_open=place == 0) for place, outcome in enumerate(outcomes)),
        id=f'r{number}',
    )


def _refused(refusal: Refusal) -> Markup:
    return element(
        'section',
        element('h2', refusal.given),
        element('p', f'was not graded: {refusal.reason}'),
        element('p', refusal.help or ''),
    )
