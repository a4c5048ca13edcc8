"""The report in a page or a cell says what the terminal says."""

from __future__ import annotations

import re
from html import unescape

from edugrade.report_html import report_html
from edugrade.results import CheckResult
from edugrade.terminal import render
from made_report import BROKE, FAILED, NOT_RUN, PASSED, report


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
