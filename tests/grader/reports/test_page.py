"""The page stands alone, and is safe to open.

The report in a page or a cell says what the terminal says.
"""

from __future__ import annotations

import re
from html import unescape
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from edugrade import Scenario
from edugrade.evidence import Outcome
from edugrade.reports.page import page, report_html, run_html
from edugrade.reports.terminal import render
from edugrade.results import CheckResult, Refusal
from made_report import BROKE, FAILED, NOT_RUN, PASSED, report

SOLUTION = Path(__file__).resolve().parents[3] / 'solutions' / 'circle.launch.py'
SCRIPT = '</script><script>alert(1)</script><img src=x onerror=alert(1)>'


def nothing(*arguments: object) -> Any:
    raise ValueError('nothing moved')


def shown(**changes: Any) -> Outcome:
    """A run with a picture and a replay."""

    class Picture:
        caption = 'turtle1 at (1, 2) & more'

        def png(self) -> bytes:
            return b'PNG'

        def __repr__(self) -> str:
            return 'one turtle'

    recording: Any = SimpleNamespace(
        **{
            'plot_turtles': Picture,
            'plot_frames': nothing,
            'plot_graph': nothing,
            'digest': lambda: 'd' * 64,
            'replay': lambda: SimpleNamespace(html=lambda: '<iframe sandbox="allow-scripts">'),
            **changes,
        }
    )
    return Outcome(Scenario('fast', {'x': SCRIPT}), 'recorded', recording)


def test_a_run_shows_its_picture_with_words_for_it_and_its_replay() -> None:
    text = run_html(shown(), is_open=True)
    assert '<img src="data:image/png;base64,UE5H" alt="one turtle">' in text
    assert 'turtle1 at (1, 2) &amp; more' in text
    assert '<iframe sandbox="allow-scripts">' in text


@pytest.mark.processes
def test_a_page_of_a_class_is_small() -> None:
    from edugrade.grading import grade, plan_work
    from edugrade.job import Limits
    from edugrade.submission import Submission

    work = plan_work(Submission(str(SOLUTION)))
    (made,) = grade([work], Limits(sandbox='off'))
    text = page([made], [], is_small=True)
    assert len(text) < 40_000 and 'data:image/png' in text and '<iframe' not in text
    assert f'edugrade {SOLUTION} --seed {work.seed} --html report.html' in text


def test_where_nothing_moved_there_is_no_replay() -> None:
    text = run_html(shown(plot_turtles=nothing, replay=nothing), is_open=False)
    assert ('<iframe' in text, '<img' in text, ' open' in text) == (False, False, False)


def test_a_run_without_a_recording_says_why() -> None:
    assert 'too slow' in run_html(Outcome(Scenario('s'), 'stopped', text='too slow'), is_open=True)


def test_nothing_that_a_student_wrote_is_markup() -> None:
    result = CheckResult('n', SCRIPT, 'failed', reason=SCRIPT, seen=SCRIPT, expected=SCRIPT, try_=SCRIPT)
    stopped = Outcome(Scenario('s', {'a': SCRIPT}), 'stopped', text=SCRIPT)
    text = page([report(result, outcome=stopped, given=SCRIPT)], [Refusal(SCRIPT, SCRIPT, SCRIPT)])
    assert re.findall('<(?:script|img)', text) == []


def test_the_page_loads_nothing_from_anywhere() -> None:
    text = page([report(PASSED, FAILED, outcome=shown())], [])
    assert "default-src 'none'" in unquoted(text)
    assert re.findall(r'(?:src|href)="(?!data:|#)[^"]*"', text) == []


def test_one_report_needs_no_table_and_two_have_one_with_links() -> None:
    assert '<table class="sum">' not in page([report(PASSED, outcome=shown())], [])
    text = page([report(PASSED, outcome=shown()), report(FAILED, outcome=shown())], [])
    assert re.findall('href="#(r[0-9])"', text) == re.findall('<section id="(r[0-9])"', text) == ['r0', 'r1']


def unquoted(text: str) -> str:
    return text.replace('&#x27;', "'")


def words(text: str) -> list[str]:
    return sorted(re.findall(r'\w+', unescape(re.sub('<[^>]*>', ' ', text))))


def test_it_has_the_words_of_the_terminal() -> None:
    graded = report(PASSED, FAILED, NOT_RUN, BROKE)
    head = render(graded).splitlines()[0]
    assert words(report_html(graded)) == words(render(graded).replace(head, ''))


def test_the_cause_comes_before_what_depends_on_it() -> None:
    text = report_html(report(PASSED, NOT_RUN, FAILED))
    places = [text.index(part) for part in ('It drives', 'It arrives', 'It starts')]
    assert places == sorted(places)


def test_nothing_of_a_student_is_markup() -> None:
    script = '<script>alert(1)</script>'
    text = report_html(report(CheckResult('n', script, 'failed', reason=script, seen=script, try_=script)))
    assert '<script' not in text
    assert text.count('&lt;script&gt;') == 5
