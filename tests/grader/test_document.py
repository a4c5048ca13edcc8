"""The JSON report is complete."""

from __future__ import annotations

import json

import pytest
from edugrade import Scenario
from edugrade.document import document, document_of_all, json_text
from edugrade.outcome import Outcome
from edugrade.results import Refusal
from edugrade.source import Gap
from made_report import BROKE, FAILED, FILE, NOT_RUN, PASSED, report


def test_every_field_of_a_failed_check_is_there() -> None:
    assert document(report(PASSED, FAILED))['checks'][1] == {
        'name': 'drives',
        'sentence': 'It drives',
        'status': 'failed',
        'points': 3,
        'earned': 0,
        'needs': ['starts'],
        'reason': 'the robot stands',
        'expected': 'a circle',
        'seen': 'no movement',
        'where': {'file': 'a.launch.py', 'line': 12},
        'try': 'look at a.launch.py:12',
        'root_cause': None,
        'cause': None,
    }


@pytest.mark.parametrize(
    ('results', 'code', 'verdict', 'earned'),
    [
        ([PASSED], 0, 'all passed', 2),
        ([PASSED, FAILED, NOT_RUN], 1, 'some failed', 2),
        ([PASSED, FAILED, BROKE], 3, 'grader broke', None),
    ],
)
def test_the_verdict_follows_from_the_checks(results: list[object], code: int, verdict: str, earned: object) -> None:
    found = document(report(*results))  # type: ignore[arg-type]
    assert (found['exit_code'], found['verdict'], found['points']['earned']) == (code, verdict, earned)


def test_a_launch_file_that_cannot_run_is_unusable_input() -> None:
    found = document(report(FAILED, outcome=Outcome(Scenario('s'), 'unusable', text=f'error in {FILE}')))
    assert (found['exit_code'], found['verdict']) == (2, 'unusable input')
    assert found['scenarios'][0]['text'] == 'error in a.launch.py'


def test_a_gap_says_where_it_is() -> None:
    assert document(report(FAILED, gaps=(Gap(FILE, 4, '# TODO 1'),)))['gaps'] == [
        {'file': 'a.launch.py', 'line': 4, 'text': '# TODO 1'}
    ]


def test_several_reports_are_one_document() -> None:
    found = document_of_all([report(PASSED), report(FAILED)], [Refusal('b', 'no such file', 'look')], 2)
    assert (found['format'], found['exit_code'], len(found['reports'])) == (2, 2, 2)
    assert found['refused'] == [{'given': 'b', 'reason': 'no such file', 'help': 'look'}]


def test_the_text_is_the_document() -> None:
    assert json.loads(json_text(document(report(PASSED)))) == document(report(PASSED))
