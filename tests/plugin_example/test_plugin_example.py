"""A plug-in of somebody else, as docs/plugins.md shows it, adds a verb, a world and a rule of advice."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

HERE = Path(__file__).parent
PAGE = HERE.parents[1] / 'docs' / 'plugins.md'


@pytest.fixture
def installed(tmp_path: Path) -> dict[str, str]:
    """The environment of a Python in which the plug-in is installed: its folder and its metadata are on the path."""
    info = tmp_path / 'site' / 'edulaunch_ferry-1.0.dist-info'
    info.mkdir(parents=True)
    text = (HERE / 'pyproject.toml').read_text()
    (info / 'METADATA').write_text('Metadata-Version: 2.1\nName: edulaunch-ferry\nVersion: 1.0\n')
    entries = re.findall(r'^(\w+) = "(ferry\.\S+)"$', text, re.M)
    (info / 'entry_points.txt').write_text('\n'.join(['[edulaunch.plugins]', *(f'{name} = {place}' for name, place in entries)]))
    path = [str(HERE), str(info.parent), os.environ.get('PYTHONPATH', '')]
    return {**os.environ, 'PYTHONPATH': os.pathsep.join(filter(None, path)), 'NO_COLOR': '1'}


def run(words: list[str], installed: dict[str, str], folder: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, '-m', 'edulaunch', *words], cwd=folder, env=installed, capture_output=True, text=True, timeout=120
    )


@pytest.mark.processes
def test_its_verb_runs_its_world(installed: dict[str, str], tmp_path: Path) -> None:
    assert '  ferry       Let the ferry cross the river\n' in run(['--help'], installed, tmp_path).stdout
    done = run(['ferry', '--speed', '0.5'], installed, tmp_path)
    assert (done.returncode, done.stdout, done.stderr) == (0, 'the ferry is at 5.0 m\n', '')


@pytest.mark.processes
def test_its_world_can_be_launched_and_its_rule_speaks(installed: dict[str, str], tmp_path: Path) -> None:
    launch = tmp_path / 'two.launch.py'
    launch.write_text(
        'from launch import LaunchDescription\nfrom launch_ros.actions import Node\n\n\n'
        'def generate_launch_description():\n'
        "    ferries = [Node(package='ferry_world', executable='ferry', name=name) for name in ('ferry1', 'ferry2')]\n"
        '    return LaunchDescription(ferries)\n'
    )
    done = run(['launch', 'two.launch.py', '--fast', '--for', '1'], installed, tmp_path)
    assert done.returncode == 0
    assert '2 ferries use one landing stage: /ferry1, /ferry2' in done.stderr
    assert 'start one of them in a namespace of its own' in done.stderr
    one = run(['launch', 'ferry_world', 'ferry.launch.py', '--fast', '--for', '1'], installed, tmp_path)
    assert one.returncode == 0 and 'landing stage' not in one.stderr


@pytest.mark.processes
def test_its_verb_and_its_package_are_completed(installed: dict[str, str], tmp_path: Path) -> None:
    for line, word in (('edulaunch fe', 'ferry'), ('ros2 launch ferry', 'ferry_world'), ('edulaunch ferry --s', '--speed')):
        assert run(['completion', 'bash', '--line', line], installed, tmp_path).stdout.split() == [word]


def test_the_page_shows_the_files_as_they_are() -> None:
    shown = re.findall(r'^`([\w./]+)`:\n\n```\w+\n(.*?)^```$', PAGE.read_text(encoding='utf-8'), re.M | re.S)
    assert [name for name, _ in shown] == ['pyproject.toml', 'ferry/plugin.py', 'ferry/verb.py', 'ferry/rules.py']
    for name, text in shown:
        assert (HERE / name).read_text() == text
