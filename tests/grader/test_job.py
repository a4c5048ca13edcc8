"""What a child is told, and the surroundings it gets."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from edugrade import Scenario
from edugrade.job import Job, Limits, import_path
from edugrade.submission import Submission

import edulaunch


@pytest.fixture
def job(tmp_path: Path) -> Job:
    (tmp_path / 'a.launch.py').touch()
    scenario = Scenario('s', {'x': '1'}, 5.0, 9)
    return Job(Submission(str(tmp_path / 'a.launch.py')), scenario, Limits(7.0), ['ws'], '/private')


def test_the_message_is_plain_data_with_absolute_paths(job: Job, tmp_path: Path) -> None:
    told = json.loads(json.dumps(job.message))
    assert told['file'] == str(tmp_path / 'a.launch.py')
    assert told['workspaces'] == [str(Path('ws').absolute())]
    assert (told['arguments'], told['duration_s'], told['seed'], told['wall_s']) == ({'x': '1'}, 5.0, 9, 7.0)


def test_nothing_of_the_callers_environment_gets_in(job: Job, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv('SECRET', 'x')
    given = job.message['environment']
    assert 'SECRET' not in given
    assert (given['HOME'], given['TMPDIR']) == ('/private', '/private')


def test_modules_of_the_current_folder_are_not_found(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr('sys.path', ['', str(tmp_path), '/lib'])
    engine = str(Path(edulaunch.__file__).parents[1])
    assert import_path() == [engine, '/lib']
