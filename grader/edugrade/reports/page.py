"""Writes reports as HTML: for a notebook cell, or as the page of ``--html`` with pictures and replays."""

from __future__ import annotations

import base64
import io
import shlex
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from ..evidence import Outcome
from ..results import FAILED, GRADER_BROKE, NOT_RUN, PASSED, CheckResult, Refusal, Report
from ..worker import Exceeded, Lost, cpu_limit, in_worker
from .markup import Markup, element, html_page, joined, table_row
from .terminal import MARKS, MORE, best_explained, next_step, of_one_cause, points_line, says_less, why_line
from .theme import PAGE, colour
from .wording import ShortPaths, at_level, explained, points_of, translated

if TYPE_CHECKING:
    from edulaunch.advice import Reader
    from edulaunch.engine.recording import Recording

POLICY = "default-src 'none'; style-src 'unsafe-inline'; img-src data:; script-src 'unsafe-inline'"
STYLE = (
    f'{PAGE}\n'
    """
body { font: 16px/1.45 system-ui, sans-serif; max-width: 62em; margin: 2em auto; padding: 0 1em; overflow-wrap: anywhere; }
h1 { font-size: 1.5em; } h2 { font-size: 1.25em; margin: 2em 0 .2em; }
table.sum { border-collapse: collapse; } table.sum th, table.sum td { text-align: left; padding: .2em 1.2em .2em 0; }
table.sum tr + tr { border-top: 1px solid var(--line); }
details { margin: .6em 0; } summary { cursor: pointer; } figure { margin: .5em 0; }
img { max-width: min(100%, 36em); } figcaption, .small { font-size: .85em; color: var(--faint); }
@media print { iframe { display: none; } }
"""
)


def page(reports: Sequence[Report], refusals: Sequence[Refusal], is_small: bool = False) -> str:
    """Return the whole page as HTML. Strings of the student are escaped. The content security policy of
    the page forbids loading other content.

    :param is_small: whether the page is part of the pages of a class. Pictures then have few colours, and the page
        shows a command in place of the replay.
    """
    parts = [_summary(reports, refusals)] if len(reports) + len(refusals) > 1 else []
    parts += [_section(report, number, is_small) for number, report in enumerate(reports)]
    parts += [_refused(refusal) for refusal in refusals]
    meta = [element('meta', name='viewport', content='width=device-width, initial-scale=1')]
    body = element('main', element('h1', 'edugrade report'), *parts)
    return html_page('edugrade report', STYLE, body, policy=POLICY, meta=meta)


def _summary(reports: Sequence[Report], refusals: Sequence[Refusal]) -> Markup:
    rows = [table_row('submission', 'result', 'checks', 'points', kind='th')]
    for number, report in enumerate(reports):
        mark = 'no mark' if report.earned is None else f'{report.earned} of {report.possible}'
        link = element('a', report.given, href=f'#r{number}')
        rows.append(table_row(link, _verdict(report), f'{report.passed} of {len(report.results)}', mark))
    rows += [table_row(refusal.given, 'refused', '-', '-') for refusal in refusals]
    return element('table', *rows, class_='sum')


def _verdict(report: Report) -> Markup:
    return element('b', report.verdict, style=f'color:{colour(FAILED if report.exit_code else PASSED)}')


def _section(report: Report, number: int, is_small: bool) -> Markup:
    paths = ShortPaths(report.folder, report.shown, report.package)
    outcomes = [outcome._replace(text=paths.text(outcome.text) or '') for outcome in report.outcomes]
    return element(
        'section',
        element('h2', report.title),
        element(
            'p',
            f'{report.given}: ',
            _verdict(report),
            f' (rubric {report.rubric}, seed {report.seed}, submission {report.sha256[:12]})',
            class_='small',
        ),
        report_html(report),
        *(run_html(outcome, is_open=place == 0, is_small=is_small) for place, outcome in enumerate(outcomes)),
        *([element('p', REPLAY.format(shlex.quote(report.given), report.seed), class_='small')] if is_small else []),
        id=f'r{number}',
    )


def _refused(refusal: Refusal) -> Markup:
    return element(
        'section',
        element('h2', refusal.given),
        element('p', f'was not graded: {refusal.reason}'),
        element('p', refusal.help or ''),
    )


_MARK = 'display:inline-block;min-width:4.6em;font-weight:bold;color:'
_FIELDS = 'border-collapse:collapse;margin:.3em 0 .3em 4.6em'
_LABEL = 'text-align:left;vertical-align:top;padding:.1em .8em .1em 0;font-weight:normal;white-space:nowrap'
_VALUE = 'text-align:left;vertical-align:top;white-space:pre-wrap;font-family:monospace;padding:.1em 0'


def report_html(report: Report) -> Markup:
    """Return a report as HTML, in the same order as in the terminal.

    The report contains failed checks, checks that were not run, passed checks, points and the next step.
    """
    from edulaunch.advice import reader_here

    reader = reader_here()
    paths = ShortPaths(report.folder, report.shown, report.package)
    results = [paths.result(translated(at_level(result, report.level), reader)) for result in report.results]
    repair = [
        _failed(alike, paths, reader, report.level)
        for status in (GRADER_BROKE, FAILED)
        for alike in of_one_cause([result for result in results if result.status == status])
    ]
    right = [_line(result, reader) for result in results if result.status == PASSED]
    word = [element('p', element('b', reader.retells(report.word)))] if report.word else []
    return joined(
        *word,
        *repair,
        *_not_run(results, reader),
        *right,
        *([element('p', why_line(report), style='margin:.8em 0 .2em')] if report.why else []),
        element('p', reader.retells(points_line(report)), style='margin:.8em 0 .2em'),
        element('p', element('b', reader.retells(next_step(report))), style='margin:.2em 0'),
        *([element('p', reader.retells(MORE), style='margin:.2em 0')] if says_less(report) else []),
    )


def _line(result: CheckResult, reader: Reader, indent: str = '0') -> Markup:
    mark = element('span', reader.says(MARKS[result.status]), style=_MARK + colour(result.status))
    return element(
        'div', mark, result.sentence, element('small', points_of(result, reader)), style=f'margin:.15em 0 .15em {indent}'
    )


def _failed(alike: Sequence[CheckResult], paths: ShortPaths, reader: Reader, level: int) -> Markup:
    """Return the checks that failed for one reason, with one explanation."""
    result = best_explained(alike)
    rows = [
        element('tr', element('th', label, style=_LABEL), element('td', text, style=_VALUE))
        for label, text in explained(result, paths, reader, level).items()
    ]
    reason = element('div', result.reason, style='margin:.2em 0 .2em 4.6em;white-space:pre-wrap')
    return joined(*(_line(each, reader) for each in alike), reason, element('table', *rows, style=_FIELDS))


def _not_run(results: list[CheckResult], reader: Reader) -> Iterator[Markup]:
    """Yield the checks that were not run, grouped by the failed check that they need."""
    waiting = [result for result in results if result.status == NOT_RUN]
    for reason in dict.fromkeys(result.reason for result in waiting):
        mark = element('span', reader.says(MARKS[NOT_RUN]), style=_MARK + colour(NOT_RUN))
        yield element('div', mark, f'{reason}:', style='margin:.15em 0')
        yield element(
            'ul',
            *(
                element('li', result.sentence, element('small', f'  [0 of {result.points}]' if result.points else ''))
                for result in waiting
                if result.reason == reason
            ),
            style='margin:.1em 0 .1em 4.6em;padding-left:1em',
        )


COLOURS_OF_SMALL = 32
REPLAY = 'For a replay of these runs: edugrade {} --seed {} --html report.html'
LONGEST_DRAWING_S = 10.0  # a drawing usually takes 0.2 s


def run_html(outcome: Outcome, is_open: bool, is_small: bool = False) -> Markup:
    """Return one run under a heading that can be opened: its arguments, its picture and its replay."""
    scenario = outcome.scenario
    heading = f'Run "{scenario.name}": {scenario.duration_s:g} s, launched with {scenario.words}'
    inside = element('p', outcome.text) if outcome.recording is None else _drawn(outcome.recording, is_small)
    attributes = {'open': ''} if is_open else {}
    return element('details', element('summary', heading), inside, **attributes)


def _drawn(recording: Recording, is_small: bool) -> Markup:
    """Return the picture and the replay from a worker. If the worker fails, return a sentence instead."""
    try:
        return Markup(in_worker(lambda: joined(*_seen(recording, is_small))))
    except (Exceeded, Lost, RuntimeError) as error:
        return _not_drawn('picture', error)


def _seen(recording: Recording, is_small: bool) -> Iterator[Markup]:
    picture = _picture(recording, is_small)
    if picture is not None:
        yield picture
    replay = None if is_small else _replay(recording)
    if replay is not None:
        yield replay
    if not is_small:
        yield from _launched(recording)
    yield element('p', f'recording {recording.digest()[:12]}', class_='small')


def _picture(recording: Recording, is_small: bool) -> Markup | None:
    """Return a picture of the turtles at the end of the run. If nothing moved, return one of the frames, or else of the nodes."""
    for plot in (recording.plot_turtles, recording.plot_frames, recording.plot_graph):
        try:
            with cpu_limit(LONGEST_DRAWING_S):
                picture = plot()
                png = _with_few_colours(picture.png()) if is_small else picture.png()
            data = base64.b64encode(png).decode('ascii')
        except ValueError:  # this view has nothing to show
            continue
        except Exception as error:  # an error such as a loop of frames must not break the rest of the page
            return _not_drawn('picture', error)
        image = element('img', src=f'data:image/png;base64,{data}', alt=repr(picture))
        return element('figure', image, element('figcaption', picture.caption))
    return None


def _with_few_colours(png: bytes) -> bytes:
    """Return the same picture with a fifth of the size."""
    from PIL import Image

    with Image.open(io.BytesIO(png)) as image, io.BytesIO() as file:
        image.convert('RGB').quantize(COLOURS_OF_SMALL, dither=Image.Dither.NONE).save(file, 'png', optimize=True)
        return file.getvalue()


def _replay(recording: Recording) -> Markup | None:
    """Return the player in an inline frame that can access neither this page nor the network."""
    try:
        with cpu_limit(LONGEST_DRAWING_S):
            return Markup(recording.replay().html())
    except ValueError:  # no turtle or robot moved
        return None
    except Exception as error:
        return _not_drawn('replay', error)


def _launched(recording: Recording) -> Iterator[Markup]:
    """Yield the tree of the launch as HTML without a script."""
    from edulaunch.desk.view.replay import outline_of

    try:
        with cpu_limit(LONGEST_DRAWING_S):
            outline = outline_of(recording)
    except Exception as error:
        yield _not_drawn('launch', error)
        return
    if outline:
        yield element('details', element('summary', 'The launch: its files, actions and processes'), Markup(outline))


def _not_drawn(view: str, error: Exception) -> Markup:
    why = f'{error.name} is not installed here' if isinstance(error, ModuleNotFoundError) else type(error).__name__
    return element('p', f'The {view} of this run could not be drawn: {why}.', class_='small')
