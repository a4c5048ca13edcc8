"""The JSON report is complete.

Everything that edugrade writes as JSON is as the published schema says.
"""

from __future__ import annotations

import json
import shutil
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from edugrade import Scenario
from edugrade.cli import SCHEMA, main
from edugrade.evidence import Outcome
from edugrade.reports.document import document, document_of_all, json_text
from edugrade.results import Refusal
from edugrade.source import Gap
from made_report import BROKE, FAILED, FILE, NOT_RUN, PASSED, report

from edulaunch.advice.rule import Finding


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


def test_a_cause_says_where_it_is_if_it_has_a_place() -> None:
    cause = Finding('argument', 'speed', {}, FILE, 4, rule='launch.argument-unused')
    for found, where in ((cause, {'file': 'a.launch.py', 'line': 4}), (cause._replace(file=None, line=None), None)):
        shown = document(report(PASSED, replace(FAILED, cause=found)))['checks'][1]['cause']
        assert (shown['rule'], shown['where']) == ('launch.argument-unused', where)


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


jsonschema = pytest.importorskip('jsonschema', reason='it comes with JupyterLab')
SOLUTION = Path(__file__).parents[3] / 'solutions' / 'static_frame.launch.py'


@pytest.fixture(scope='module')
def schema() -> Any:
    found = json.loads(Path(SCHEMA).read_text('utf-8'))
    jsonschema.Draft202012Validator.check_schema(found)
    return jsonschema.Draft202012Validator(found)


@pytest.mark.processes
def test_one_report_and_several(schema: Any, tmp_path: Path) -> None:
    main([str(SOLUTION), '--json', str(tmp_path / 'one')])
    main([str(SOLUTION), 'nowhere.launch.py', '--json', str(tmp_path / 'two')])
    for name in ('one', 'two'):
        schema.validate(json.loads((tmp_path / name).read_text()))


@pytest.mark.processes
def test_the_results_of_a_batch(schema: Any, tmp_path: Path) -> None:
    (tmp_path / 'class' / 'anna').mkdir(parents=True)
    shutil.copy(SOLUTION, tmp_path / 'class' / 'anna')
    (tmp_path / 'class' / 'bert').mkdir()
    (tmp_path / 'class' / 'bert' / 'static_frame.launch.py').write_text('import nothing')
    (tmp_path / 'class' / 'carl').mkdir()
    main(['batch', str(tmp_path / 'class')])
    main(['batch', str(tmp_path / 'class'), '--only', 'laser_is_on_tf'])
    found = sorted(tmp_path.glob('class.results/**/*.json'))
    assert len(found) == 3
    for path in found:
        schema.validate(json.loads(path.read_text()))


def made() -> dict[str, Any]:
    """A report that was made by hand, with the hashes that it lacks."""
    found = document(report(PASSED, FAILED, NOT_RUN, BROKE))
    found['submission']['sha256'] = '0' * 64
    found['receipt'].update(submission='0' * 64, rubric='0' * 64)
    return found


def test_every_kind_of_check(schema: Any) -> None:
    schema.validate(made())


@pytest.mark.parametrize(
    'spoilt', [('verdict', 'fine'), ('points', {'earned': -1, 'possible': 3}), ('checks', []), ('receipt', {})]
)
def test_what_is_no_report_is_found(schema: Any, spoilt: tuple[str, Any]) -> None:
    with pytest.raises(jsonschema.ValidationError):
        schema.validate({**made(), spoilt[0]: spoilt[1]})


def test_the_command_prints_it(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['schema']) == 0
    assert json.loads(capsys.readouterr().out)['$id'] == 'urn:edugrade:report:2'
