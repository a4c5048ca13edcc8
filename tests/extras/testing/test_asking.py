"""Runs of pytest that ask for ROS tests, and runs that do not and are left alone."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

ALONE = """
import importlib.util, sys
def test_alone(pytestconfig):
    assert 'edulaunch.ros.sourcing' not in sys.modules and importlib.util.find_spec('rclpy') is None
    assert not [finder for finder in sys.meta_path if type(finder).__module__.startswith('edulaunch')]
    assert not hasattr(pytestconfig.option, 'launch_args')
"""
HELPED = """
import rclpy, time
def test_helped(pytestconfig):
    assert pytestconfig.option.launch_args == []
"""
UNCONCERNED = ('-p', 'no:nbval', '-p', 'no:hypothesispytest')
"""Plugins that have nothing to do with it, and take two seconds to load."""
PACKAGE = '<package format="3"><name>bot</name><version>0.0.1</version></package>'


def run(folder: Path, *words: str) -> str:
    env = {name: value for name, value in os.environ.items() if name not in ('PYTHONPATH', 'PYTEST_ADDOPTS')}
    command = [sys.executable, '-m', 'pytest', '-q', '-p', 'no:cacheprovider', *UNCONCERNED, *words]
    done = subprocess.run(command, cwd=folder, env=env, capture_output=True, text=True, check=False)
    return done.stdout + done.stderr


@pytest.mark.processes
def test_a_project_that_does_not_ask_is_left_alone(tmp_path: Path) -> None:
    (tmp_path / 'test_alone.py').write_text(ALONE)
    assert '1 passed' in run(tmp_path)


@pytest.mark.processes
@pytest.mark.parametrize(
    'way',
    [
        'package',
        *(pytest.param(way, marks=pytest.mark.whole) for way in ('-p edulaunch', 'addopts', 'workspace', 'a file of a package')),
    ],
)
def test_a_project_asks(way: str, tmp_path: Path) -> None:
    tests, words = tmp_path, []
    if way == '-p edulaunch':
        words = way.split()
    elif way == 'addopts':
        (tmp_path / 'pytest.ini').write_text('[pytest]\naddopts = -p edulaunch\n')
    else:
        package = tmp_path if way == 'package' else tmp_path / 'src' / 'bot'
        tests = package / 'test'
        tests.mkdir(parents=True)
        (package / 'package.xml').write_text(PACKAGE)
        words = [] if way != 'a file of a package' else ['src/bot/test/test_helped.py::test_helped']
    (tests / 'test_helped.py').write_text(HELPED)
    assert '1 passed' in run(tmp_path, *words)


@pytest.mark.whole
@pytest.mark.parametrize('below', ['', 'launch_testing'])
def test_the_sources_of_ros_beside_the_tests_are_not_taken_for_an_installed_ros(below: str, tmp_path: Path) -> None:
    for name in ('launch', 'launch_testing'):
        (tmp_path / name / name).mkdir(parents=True)
        (tmp_path / name / name / '__init__.py').write_text('OTHER = 1\n')
    tests = tmp_path / 'launch_testing' / 'test'
    tests.mkdir()
    (tests / 'test_one_copy.py').write_text("""
import sys
import launch, launch_testing
from launch_testing.actions import ReadyToTest
def test_one_copy(pytestconfig):
    assert pytestconfig.option.launch_args == []
    assert sys.modules['launch'] is launch and issubclass(ReadyToTest, launch.Action)
    assert not hasattr(launch, 'OTHER') and not hasattr(launch_testing, 'OTHER')
""")
    assert '1 passed' in run(tmp_path / below, '-p', 'edulaunch', str(tests))
