"""Each submission in golden/ gets exactly its report: as text, and as data."""

from __future__ import annotations

from functools import cache

import pytest
from golden_reports import CASES, FOLDER, grade_all

graded = cache(grade_all)


@pytest.mark.processes
@pytest.mark.parametrize('case', CASES)
def test_the_terminal_shows_the_golden_text(case: str) -> None:
    assert graded()[case][0] == (FOLDER / case / 'report.txt').read_text(encoding='utf-8')


@pytest.mark.processes
@pytest.mark.parametrize('case', CASES)
def test_the_json_report_is_the_golden_one(case: str) -> None:
    assert graded()[case][1] == (FOLDER / case / 'report.json').read_text(encoding='utf-8')
