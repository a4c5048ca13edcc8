"""The page stands alone, and is safe to open."""

from __future__ import annotations

import re
from types import SimpleNamespace
from typing import Any

from edugrade import Scenario
from edugrade.outcome import Outcome
from edugrade.page import page
from edugrade.results import CheckResult, Refusal
from edugrade.run_html import run_html
from made_report import FAILED, PASSED, report

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
