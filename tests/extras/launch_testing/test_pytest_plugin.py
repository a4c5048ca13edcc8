"""The pytest plugin and the command `launch_test`, as a user starts them."""

from __future__ import annotations

import os
import subprocess
import sys
from importlib import import_module
from pathlib import Path
from xml.etree import ElementTree

import pytest
from launch_testing.pytest.hooks import is_launch_test

from edulaunch.extras.launch_test import main
from edulaunch.extras.testing import workspaces_of

from .conftest import CORPUS

MARKED = b'@pytest.mark.launch_test\ndef generate_test_description():\n    pass\n'


@pytest.mark.parametrize(
    ('source', 'answer'),
    [
        (MARKED, True),
        (MARKED.replace(b'launch_test', b'rostest()'), True),
        (MARKED.replace(b'pytest.mark', b'mark'), True),
        (MARKED.replace(b'launch_test', b'skip'), False),
        (b'"""launch_test generate_test_description"""', False),
        (b'launch_test generate_test_description ((', False),
    ],
)
def test_a_launch_test_is_a_marked_function(source: bytes, answer: bool) -> None:
    assert is_launch_test(source) is answer


@pytest.mark.whole
def test_pytest_runs_launch_tests_among_others(tmp_path: Path) -> None:
    for name in ('talker', 'failing', 'forgetful'):
        (tmp_path / f'test_{name}.py').write_bytes((CORPUS / f'{name}.py').read_bytes())
    (tmp_path / 'test_plain.py').write_text('def test_plain():\n    pass\n')
    here = str(Path(__file__).resolve().parents[3])
    env = {**os.environ, 'PYTHONPATH': here, 'PYTEST_DISABLE_PLUGIN_AUTOLOAD': '1', 'PYTHONDONTWRITEBYTECODE': '1'}
    command = [
        sys.executable,
        '-m',
        'pytest',
        *('-p', 'no:nbval', '-p', 'no:hypothesispytest'),
        '-p',
        'edulaunch.extras.pytest_plugin',
        '-p',
        'no:cacheprovider',
        '--strict-markers',
        '-v',
        'test_plain.py',
        'test_talker.py',
        'test_failing.py',
        'test_forgetful.py',
    ]
    done = subprocess.run(command, cwd=tmp_path, env=env, capture_output=True, text=True, check=False)
    assert done.returncode == 1, done.stdout + done.stderr
    lines = [line.partition(' [')[0].rstrip() for line in done.stdout.splitlines() if '::' in line and line.startswith('test_')]
    assert lines == [
        'test_plain.py::test_plain PASSED',
        'test_talker.py::test_talker PASSED',
        'test_failing.py::test_failing FAILED',
        'test_forgetful.py::test_forgetful FAILED',
    ]
    assert 'ERROR: test_c_broken (test_failing.TestClaims.test_c_broken) [test_failing]\nTraceback' in done.stdout
    assert 'launch_testing/launch_test.py' not in done.stdout, 'frames of ours are not shown'


def test_the_command_writes_junit_xml(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    report = tmp_path / 'report.xml'
    assert main([str(CORPUS / 'parametrized.py'), 'who:=me', '--junit-xml', str(report), '--package-name', 'mine']) == 0
    root = ElementTree.parse(report).getroot()
    assert [(suite.get('name'), suite.get('tests'), suite.get('failures')) for suite in root] == [
        ('mine.parametrized.parametrized[one, 1]', '1', '0'),
        ('mine.parametrized.parametrized[two, 2]', '1', '0'),
    ]


def test_the_command_shows_launch_arguments(capsys: pytest.CaptureFixture[str]) -> None:
    assert main([str(CORPUS / 'parametrized.py'), '-s']) == 0
    assert capsys.readouterr().out == (
        "Arguments (pass arguments as '<name>:=<value>'):\n\n    'who':\n"
        "        no description given\n        (default: 'nobody')\n"
    )


def test_the_command_is_installed_under_its_name_in_ros() -> None:
    tomllib = pytest.importorskip('tomllib')
    project = Path(__file__).resolve().parents[3] / 'pyproject.toml'
    module, _, function = tomllib.loads(project.read_text('utf-8'))['project']['scripts']['launch_test'].partition(':')
    assert getattr(import_module(module), function) is main


def test_the_command_refuses_a_missing_file(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as end:
        main(['nowhere.py'])
    assert end.value.code == 2
    assert "launch_test: error: Test file 'nowhere.py' does not exist" in capsys.readouterr().err


def test_a_test_sees_the_packages_around_it(tmp_path: Path) -> None:
    package = tmp_path / 'ws' / 'src' / 'pkg'
    (package / 'test').mkdir(parents=True)
    (package / 'package.xml').write_text('<package/>')
    assert workspaces_of(str(package / 'test' / 'test_it.py')) == [str(tmp_path / 'ws')]
    assert workspaces_of(str(tmp_path / 'test_it.py')) == []
