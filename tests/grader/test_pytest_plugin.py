"""``pytest --edugrade``: every check of a launch file's rubric is a test."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

import pytest

ROOT = Path(__file__).parents[2]


QUICK = ('-p', 'no:nbval', '-p', 'no:hypothesispytest')


def run_pytest(folder: Path, *words: str) -> subprocess.CompletedProcess[str]:
    command = [
        sys.executable,
        '-m',
        'pytest',
        '-p',
        'no:cacheprovider',
        *QUICK,
        '-c',
        '/dev/null',
        '--rootdir',
        str(folder),
        str(folder),
    ]
    plugin = ['-p', 'edugrade.pytest_plugin'] if 'edugrade' not in installed() else []
    return subprocess.run([*command, *plugin, *words], cwd=folder, capture_output=True, text=True, env=environment())


def installed() -> list[str]:
    from importlib.metadata import entry_points

    return [point.name for point in entry_points(group='pytest11')]


def environment() -> dict[str, str]:
    import os

    return {**os.environ, 'PYTHONPATH': os.pathsep.join(filter(None, sys.path))}


@pytest.mark.whole
def test_checks_pass_fail_and_are_skipped(tmp_path: Path) -> None:
    (tmp_path / 'right').mkdir()
    shutil.copy(ROOT / 'solutions' / 'static_frame.launch.py', tmp_path / 'right')
    shutil.copy(ROOT / 'exercises' / 'circle.launch.py', tmp_path)
    (tmp_path / 'unknown.launch.py').write_text('')
    done = run_pytest(tmp_path, '--edugrade', '--junit-xml', str(tmp_path / 'out.xml'), '-rs')
    assert '3 failed, 11 passed, 2 skipped' in done.stdout, done.stdout
    assert 'the launch argument "circle_radius" is missing' in done.stdout
    assert 'try: add DeclareLaunchArgument' in done.stdout and 'Traceback' not in done.stdout
    cases = {case.get('name'): case for case in ElementTree.parse(tmp_path / 'out.xml').iter('testcase')}
    found = {item.get('name'): item.get('value') for item in cases['laser_is_in_its_place'].iter('property')}
    assert found == {'points': '3', 'earned': '3'}


@pytest.mark.processes
def test_nothing_is_collected_unless_it_is_asked_for(tmp_path: Path) -> None:
    shutil.copy(ROOT / 'solutions' / 'static_frame.launch.py', tmp_path)
    assert 'no tests ran' in run_pytest(tmp_path).stdout
