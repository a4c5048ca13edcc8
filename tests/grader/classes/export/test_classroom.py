"""The autograding of GitHub Classroom: every check a command, with its points."""

from __future__ import annotations

import json
import shlex
import shutil
from pathlib import Path

import pytest
import yaml
from edugrade.classes.export.classroom import tests as classroom_tests
from edugrade.cli import main

ROOT = Path(__file__).parents[4]


def test_workflow_and_autograding_ask_for_the_same(tmp_path: Path) -> None:
    assert main(['classroom', 'circle', 'large_project=src/large_project', '--out', str(tmp_path)]) == 0
    workflow = yaml.safe_load((tmp_path / '.github' / 'workflows' / 'classroom.yml').read_text())
    tests = json.loads((tmp_path / '.github' / 'classroom' / 'autograding.json').read_text())['tests']
    job = workflow['jobs']['run-autograding-tests']
    steps = [step for step in job['steps'] if 'command-grader' in step.get('uses', '')]
    assert [(step['with']['command'], step['with']['max-score']) for step in steps] == [
        (test['run'], test['points']) for test in tests
    ]
    assert sum(test['points'] for test in tests) == 24
    reporter = job['steps'][-1]
    assert reporter['with']['runners'].split(',') == [step['id'] for step in steps]
    assert set(reporter['env']) == {f'{step["id"].upper()}_RESULTS' for step in steps}
    assert all(set(step['id']) <= set('abcdefghijklmnopqrstuvwxyz0123456789_-') for step in steps)
    assert True not in workflow and 'on' in workflow, 'YAML 1.1 reads a bare on as true'


@pytest.mark.processes
@pytest.mark.parametrize(('folder', 'code'), [('solutions', 0), ('exercises', 1)])
def test_a_command_ends_as_its_check_does(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, folder: str, code: int) -> None:
    shutil.copy(ROOT / folder / 'static_frame.launch.py', tmp_path)
    monkeypatch.chdir(tmp_path)
    test = next(test for test in classroom_tests('static_frame') if test.id.endswith('camera_is_on_tf'))
    assert main(shlex.split(test.command)[1:]) == code
