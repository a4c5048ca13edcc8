"""An autograder for Gradescope: packed, unpacked, and run as Gradescope does."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path
from typing import Any

import pytest
from edugrade.classes.export.gradescope import refused, results, run
from edugrade.cli import main

SOLUTION = Path(__file__).parents[4] / 'solutions' / 'static_frame.launch.py'
# What the specification knows, and of which type (gradescope-autograders.readthedocs.io, "Output Format").
TOP = {
    'score': (int, float),
    'execution_time': (int, float),
    'output': str,
    'output_format': str,
    'test_output_format': str,
    'test_name_format': str,
    'visibility': str,
    'stdout_visibility': str,
    'extra_data': dict,
    'tests': list,
    'leaderboard': list,
}
TEST = {
    'score': (int, float),
    'max_score': (int, float),
    'status': str,
    'name': str,
    'name_format': str,
    'number': str,
    'output': str,
    'output_format': str,
    'tags': list,
    'visibility': str,
    'extra_data': dict,
}


def assert_follows_the_specification(found: dict[str, Any]) -> None:
    for known, part in ((TOP, found), *((TEST, test) for test in found['tests'])):
        wrong = {key: value for key, value in part.items() if key not in known or not isinstance(value, known[key])}  # type: ignore[arg-type]
        assert not wrong
    assert {test['status'] for test in found['tests']} <= {'passed', 'failed'}
    assert found['visibility'] in ('visible', 'hidden', 'after_due_date', 'after_published')
    assert found['score'] == sum(test['score'] for test in found['tests'])
    assert all(0 <= test['score'] <= test['max_score'] for test in found['tests'])


@pytest.fixture
def autograder(tmp_path: Path) -> Path:
    """Gradescope's folder, with an autograder and metadata, and nothing handed in."""
    (tmp_path / 'secret').write_text('0123456789abcdef')
    (tmp_path / 'edulaunch-0-py3-none-any.whl').write_bytes(b'wheel')
    words = ['--wheel', str(tmp_path / 'edulaunch-0-py3-none-any.whl'), '--course-secret-file', str(tmp_path / 'secret')]
    for name in ('a.zip', 'b.zip'):
        assert main(['gradescope', 'build', 'static_frame', '--out', str(tmp_path / name), *words]) == 0
    assert (tmp_path / 'a.zip').read_bytes() == (tmp_path / 'b.zip').read_bytes()
    folder = tmp_path / 'autograder'
    for name in ('submission', 'results'):
        (folder / name).mkdir(parents=True)
    with zipfile.ZipFile(tmp_path / 'a.zip') as archive:
        for info in archive.infolist():
            path = Path(archive.extract(info, folder / 'source'))
            path.chmod(info.external_attr >> 16)
    metadata = {'users': [{'id': 2, 'name': 'Bob', 'email': 'b'}, {'id': 1, 'name': 'Ada', 'email': 'a'}]}
    (folder / 'submission_metadata.json').write_text(json.dumps(metadata))
    return folder


def found_in(folder: Path) -> dict[str, Any]:
    found: dict[str, Any] = json.loads((folder / 'results' / 'results.json').read_text())
    assert_follows_the_specification(found)
    return found


def test_the_zip_has_what_gradescope_runs(autograder: Path) -> None:
    source = autograder / 'source'
    assert sorted(path.name for path in source.iterdir() if path.is_file()) == [
        *('course_secret', 'edugrade.json', 'edulaunch-0-py3-none-any.whl', 'run_autograder', 'setup.sh')
    ]
    assert 'pip install /autograder/source/edulaunch-0-py3-none-any.whl' in (source / 'setup.sh').read_text()
    for name in ('setup.sh', 'run_autograder'):
        assert os.access(source / name, os.X_OK)
        subprocess.run(['bash', '-n', str(source / name)], check=True)


@pytest.mark.processes
def test_run_autograder_grades_what_was_handed_in(autograder: Path, tmp_path: Path) -> None:
    shutil.copy(SOLUTION, autograder / 'submission')
    (tmp_path / 'bin').mkdir()
    (tmp_path / 'bin' / 'edugrade').write_text(f'#!/bin/sh\nexec {sys.executable} -m edugrade "$@"\n')
    (tmp_path / 'bin' / 'edugrade').chmod(0o755)
    environment = {**os.environ, 'PATH': f'{tmp_path / "bin"}:{os.environ["PATH"]}', 'AUTOGRADER': str(autograder)}
    environment['PYTHONPATH'] = os.pathsep.join(sys.path)
    done = subprocess.run(
        [str(autograder / 'source' / 'run_autograder')], env=environment, capture_output=True, text=True, cwd=tmp_path
    )
    assert done.returncode == 0, done.stderr
    found = found_in(autograder)
    assert (found['score'], found['tests'][1]['name']) == (12, 'No node dies before the end')
    assert found['extra_data']['edugrade']['receipt']['secret']


@pytest.mark.processes
@pytest.mark.parametrize('text', ['x = 1\n', 'import nothing\n', 'def ('])
def test_a_wrong_answer_and_a_broken_one(autograder: Path, text: str) -> None:
    (autograder / 'submission' / 'static_frame.launch.py').write_text(text)
    assert run(str(autograder)) == 0
    found = found_in(autograder)
    assert found['score'] == 0
    assert found['tests'][0]['output']


@pytest.mark.processes
def test_an_archive_and_a_package_below_are_found(autograder: Path) -> None:
    with zipfile.ZipFile(autograder / 'submission' / 'work.zip', 'w') as archive:
        archive.write(SOLUTION, 'ws/static_frame.launch.py')
    assert run(str(autograder)) == 0
    assert found_in(autograder)['score'] == 12


def test_nothing_to_grade_is_said(autograder: Path) -> None:
    (autograder / 'submission' / 'readme.md').write_text('hello')
    assert run(str(autograder)) == 0
    found = found_in(autograder)
    assert (found['score'], found['tests'][0]['max_score']) == (0, 12)
    assert 'there is no static_frame.launch.py' in found['output']


@pytest.mark.processes
def test_a_fault_of_ours_gives_no_score(autograder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    shutil.copy(SOLUTION, autograder / 'submission')
    (rubric,) = (autograder / 'source' / 'rubrics').iterdir()
    rubric.write_text(rubric.read_text().replace('    require_default(run', '    oops(run'))
    assert main(['gradescope', 'run', str(autograder)]) == 3
    assert not (autograder / 'results' / 'results.json').exists()
    assert "name 'oops' is not defined" in capsys.readouterr().err


def test_no_text_of_a_student_moves_a_cursor() -> None:
    check = {'sentence': 'a\x1b[2J', 'earned': 0.5, 'points': 2, 'status': 'failed', 'reason': '\x1b[31m', 'expected': None}
    found = results(
        {
            'points': {'earned': 0.5, 'possible': 2},
            'rubric': {'title': 't'},
            'verdict': 'some failed',
            'seed': 1,
            'receipt': {},
            'checks': [{**check, 'seen': None, 'try': None, 'where': None}],
        }
    )
    assert_follows_the_specification(found)
    assert '\x1b' not in json.dumps(found) and '\\u001b' not in json.dumps(found)
    assert_follows_the_specification(refused('\x1b', 12))


def test_without_a_wheel_it_says_what_gradescope_needs(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    wheel = tmp_path / 'edulaunch-1.whl'
    wheel.write_bytes(b'')
    for words, is_needed in ((['--wheel', str(wheel)], False), ([], True)):
        assert main(['gradescope', 'build', 'circle', '--out', str(tmp_path / 'a.zip'), *words]) == 0
        assert ('If this version is not published there, use --wheel FILE.' in capsys.readouterr().err) is is_needed
