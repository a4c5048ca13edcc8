"""What a child is told, and the surroundings it gets.

A run reads the engine and Python's packages, and nothing of the grader, in whatever way both are installed.
"""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest
from edugrade import Scenario
from edugrade.job import Limits, RunRequest, readable_by_run
from edugrade.places import import_path, readable_by_all
from edugrade.submission import Submission

import edulaunch


@pytest.fixture
def job(tmp_path: Path) -> RunRequest:
    (tmp_path / 'a.launch.py').touch()
    scenario = Scenario('s', {'x': '1'}, 5.0, 9)
    return RunRequest(Submission(str(tmp_path / 'a.launch.py')), scenario, Limits(7.0), ['ws'], '/private')


def test_the_message_is_plain_data_with_absolute_paths(job: RunRequest, tmp_path: Path) -> None:
    told = json.loads(json.dumps(job.message))
    assert told['file'] == str(tmp_path / 'a.launch.py')
    assert told['workspaces'] == [str(Path('ws').absolute())]
    assert (told['arguments'], told['duration_s'], told['seed'], told['wall_s']) == ({'x': '1'}, 5.0, 9, 7.0)


def test_nothing_of_the_callers_environment_gets_in(job: RunRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv('SECRET', 'x')
    given = job.message['environment']
    assert 'SECRET' not in given
    assert (given['HOME'], given['TMPDIR']) == ('/private', '/private')


def test_modules_of_the_current_folder_are_not_found(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / 'mine' / 'greenlet').mkdir(parents=True)
    packages = str(tmp_path / 'lib' / 'site-packages')
    monkeypatch.setattr('sys.path', ['', str(tmp_path), str(tmp_path / 'tests'), str(tmp_path / 'mine'), packages])
    engine = str(Path(edulaunch.__file__).parents[1])
    assert import_path() == [engine, str(tmp_path / 'mine'), packages]


def allows(read: list[str], path: Path) -> bool:
    return any(os.path.realpath(path).startswith(os.path.join(os.path.realpath(place), '')) for place in read)


def test_the_grader_is_hidden_among_the_installed_packages(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    packages = tmp_path / 'lib' / 'site-packages'
    for name in ('numpy', 'edugrade/checks', 'edugrade/sandbox', 'elsewhere'):
        (packages / name).mkdir(parents=True)
    (tmp_path / 'lib64').symlink_to('lib')
    (packages / 'ring').symlink_to('..')
    (packages / 'again').symlink_to('edugrade/checks')
    monkeypatch.setattr('sys.prefix', str(tmp_path))
    monkeypatch.setattr('edugrade.places.__file__', str(packages / 'edugrade' / 'readable.py'))
    monkeypatch.setattr('edugrade.rubrics.catalogue.rubrics_folder', lambda: str(packages / 'edugrade' / 'checks'))
    read, listed = readable_by_all([str(packages)])
    assert allows(read, packages / 'numpy' / 'a.py')
    assert not allows(read, packages / 'edugrade' / 'checks' / 'circle.py')
    assert not allows(read, packages / 'edugrade' / 'sandbox' / 'child.py')
    assert {str(tmp_path), str(tmp_path / 'lib'), str(packages)} <= set(listed)


def test_of_a_folder_in_pythonpath_only_needed_packages_are_read(tmp_path: Path) -> None:
    for name in ('greenlet', 'keys'):
        (tmp_path / name).mkdir()
    read, listed = readable_by_all([str(tmp_path)])
    assert allows(read, tmp_path / 'greenlet' / 'a.py') and not allows(read, tmp_path / 'keys' / 'private.pem')
    assert str(tmp_path) in listed


def test_of_a_checkout_only_the_engine_is_read(tmp_path: Path) -> None:
    for name in ('edulaunch', 'solutions', 'tests'):
        (tmp_path / name).mkdir()
    read, _ = readable_by_all([str(tmp_path)])
    assert not allows(read, tmp_path / 'solutions' / 'circle.launch.py')


def test_a_launch_file_alone_reads_itself_and_a_package_its_folder(tmp_path: Path) -> None:
    alone = tmp_path / 'a.launch.py'
    alone.touch()
    assert readable_by_run(Submission(str(alone)), ['/ws']) == [str(alone), '/ws']
    (tmp_path / 'p' / 'launch').mkdir(parents=True)
    (tmp_path / 'p' / 'package.xml').write_text('<package><name>p</name></package>')
    inside = tmp_path / 'p' / 'launch' / 'p.launch.py'
    inside.touch()
    assert readable_by_run(Submission(str(inside)), []) == [str(tmp_path / 'p')]
