"""The JSON report is complete, and written whole or not at all."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from edugrade import Scenario
from edugrade.document import document, write_document
from edugrade.outcome import Outcome
from made_report import BROKE, FAILED, FILE, NOT_RUN, PASSED, report

from edulaunch.errors import UnusableInput


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
    }


@pytest.mark.parametrize(
    ('results', 'code', 'verdict', 'earned'),
    [
        ([PASSED], 0, 'all passed', 2),
        ([PASSED, FAILED, NOT_RUN], 1, 'some failed', 2),
        ([PASSED, FAILED, BROKE], 3, 'grader broke', None),
    ],
)
def test_the_verdict_follows_from_the_checks(
    results: list[object], code: int, verdict: str, earned: object
) -> None:
    found = document(report(*results))  # type: ignore[arg-type]
    assert (found['exit_code'], found['verdict'], found['points']['earned']) == (code, verdict, earned)


def test_a_launch_file_that_cannot_run_is_unusable_input() -> None:
    found = document(report(FAILED, outcome=Outcome(Scenario('s'), 'unusable', text=f'error in {FILE}')))
    assert (found['exit_code'], found['verdict']) == (2, 'unusable input')
    assert found['scenarios'][0]['text'] == 'error in a.launch.py'


def test_the_written_file_is_the_document(tmp_path: Path) -> None:
    write_document(report(PASSED), str(tmp_path / 'report.json'))
    assert json.loads((tmp_path / 'report.json').read_text()) == document(report(PASSED))
    assert [path.name for path in tmp_path.iterdir()] == ['report.json']


def test_a_place_that_cannot_be_written_is_named(tmp_path: Path) -> None:
    with pytest.raises(UnusableInput, match='cannot be written: No such file or directory'):
        write_document(report(PASSED), str(tmp_path / 'nowhere' / 'report.json'))
