"""Reports of the grader in a real browser: on the screen of a phone nothing has to be pushed aside."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest
from edugrade.classes.batch.entries import Entry
from edugrade.classes.batch.tables import class_page
from edugrade.reports.page import page

from tests.grader.made_report import FAILED, PASSED, report

pytestmark = pytest.mark.browser
LONG = 'a_name_without_a_place_to_break_' * 4
LINES_OF_LABELS = """() => [...document.querySelectorAll('th[style]')].map(label => {
    const text = document.createRange();
    text.selectNodeContents(label);
    return text.getClientRects().length;
})"""


def test_reports_fit_the_screen_of_a_phone(browser: Any) -> None:
    entry = Entry(f'{LONG}/circle.launch.py', LONG, LONG)
    work = browser.new_page(viewport={'width': 400, 'height': 800})
    for text in (page([report(PASSED, replace(FAILED, seen=LONG), given=LONG)], []), class_page([(entry, None)] * 2, {})):
        work.set_content(text)
        assert work.evaluate('() => document.documentElement.scrollWidth') <= 400
        assert set(work.evaluate(LINES_OF_LABELS)) <= {1}
    work.close()
