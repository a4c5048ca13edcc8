"""The table for several submissions."""

from __future__ import annotations

from edugrade.results import Refusal
from edugrade.summary import summary
from made_report import BROKE, FAILED, PASSED, report

EXPECTED = """\
submission   result         checks  points
------------------------------------------
good         all passed     1 of 1  2 of 2
bad          FAILED         1 of 2  2 of 5
odd          BROKE          1 of 2  no mark
nowhere      REFUSED        -       -
------------------------------------------
sum          1 of 4 passed  3 of 5  4 of 10

nowhere was not graded: nowhere does not exist
  help: look
"""


def test_every_submission_has_a_line_in_words() -> None:
    reports = [report(PASSED, given='good'), report(PASSED, FAILED, given='bad'), report(PASSED, BROKE, given='odd')]
    lines = summary(reports, [Refusal('nowhere', 'nowhere does not exist', 'look')]).splitlines()
    assert [line.split() for line in lines if '---' not in line] == [
        line.split() for line in EXPECTED.splitlines() if '---' not in line
    ]


def test_columns_are_aligned() -> None:
    lines = summary([report(PASSED), report(FAILED, given='b' * 40)], []).splitlines()
    assert len({line.index('of') for line in (lines[2], lines[3])}) == 1


def test_a_name_cannot_repaint_the_table() -> None:
    assert '\x1b' not in summary([report(PASSED, given='a\x1b[2J')], [])
