"""Every launch file, node and parameter file of the seeds does here what it does with ROS 2."""

from __future__ import annotations

import json
import re
import shutil
from pathlib import Path
from typing import Any

import pytest

import edulaunch
from edulaunch.advice import Finding

SEEDS = Path(__file__).resolve().parents[2] / 'shared' / 'seeds'
OURS = {'tuos_simulations', 'turtlebot3_gazebo', 'part3_beyond_basics'}
pytestmark = pytest.mark.skipif(not SEEDS.is_dir(), reason='the seed tutorials are not beside this repository')


def rows(kind: str) -> list[dict[str, Any]]:
    if not SEEDS.is_dir():
        return []
    index = json.loads((SEEDS / 'files' / 'index.json').read_text())
    return [row for row in index if row['kind'] == kind and not row['file'].startswith('stand_ins/')]


def runs_here(row: dict[str, Any], oracle: dict[str, Any]) -> bool:
    """What `strict` says of real ROS 2, but for packages that exist in our underlay."""
    if oracle['strict']['outcome'] == 'plan':
        return True
    missing = re.search(r"package '(\w+)' not found", oracle['strict'].get('error', ''))
    return bool(missing) and missing.group(1) in OURS


CASES = [(row, oracle) for row in rows('python_launch') for oracle in row['oracle']]
RUNNING = [(row['file'], oracle) for row, oracle in CASES if runs_here(row, oracle)]
FAILING = [(row['file'], oracle) for row, oracle in CASES if not runs_here(row, oracle)]


def name_of(case: Any) -> str:
    return case if isinstance(case, str) else ' '.join(case['args']) or 'no arguments'


@pytest.fixture(scope='module')
def workspace(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The packages of the seeds, as a student's source workspace."""
    return make_workspace(tmp_path_factory.mktemp('ws'))


def make_workspace(folder: Path) -> Path:
    for package in (
        'large_projects/launch_tutorial',
        'launch_lesson/simple_robot_launch',
        'launch_lesson/week5_lesson1_launch_example',
        'tf2_book/learning_tf2_py',
    ):
        shutil.copytree(SEEDS / 'files' / package, folder / 'src' / package.rpartition('/')[2])
    return folder


def at_stage(file: str, folder: Path) -> Path:
    """A workspace as it was when the tutorial showed this file: the other files of that stage replace the final ones."""
    package = make_workspace(folder) / 'src' / 'launch_tutorial'
    for other in sorted((SEEDS / 'files' / file).parent.iterdir()):
        shutil.copy(other, package / ('config' if other.suffix == '.yaml' else 'launch') / other.name)
    return folder


def arguments(oracle: dict[str, Any]) -> dict[str, str]:
    return dict(word.split(':=', 1) for word in oracle['args'])


@pytest.mark.parametrize(('file', 'oracle'), RUNNING, ids=name_of)
def test_what_runs_with_ros_runs_here(file: str, oracle: dict[str, Any], workspace: Path, tmp_path: Path) -> None:
    if file.startswith('large_projects/stage'):
        workspace = at_stage(file, tmp_path)
    recording = edulaunch.run(SEEDS / 'files' / file, arguments=arguments(oracle), duration_s=6.0, workspaces=[workspace])
    names = [node.name for node in recording.nodes]
    expected = [re.sub(r'^/student_', f'/{user()}_', name) for name in oracle.get('nodes', ())]
    missing = [name for name in expected if name not in names and not name.startswith('(')]
    dead = [one for one in recording.advice if one.rule == 'programs.died' and not dies_in_ros_too(oracle, one)]
    assert (missing, dead, recording.launch.error) == ([], [], None)


def dies_in_ros_too(oracle: dict[str, Any], found: Finding) -> bool:
    """A whole number for a parameter of type double ends the node in ROS 2 as well; launch's plan does not show that."""
    return oracle['args'] == ['circle_radius:=2'] and "'2' of type 'INTEGER', expecting type 'DOUBLE'" in found.facts['error']


def user() -> str:
    import os

    return os.environ.get('USER', 'student')


@pytest.mark.parametrize(('file', 'oracle'), FAILING, ids=name_of)
def test_what_fails_with_ros_fails_with_its_error_and_a_line_of_help(file: str, oracle: dict[str, Any], workspace: Path) -> None:
    with pytest.raises(edulaunch.LaunchFileError) as caught:
        edulaunch.run(SEEDS / 'files' / file, arguments=arguments(oracle), duration_s=1.0, workspaces=[workspace])
    said, expected = str(caught.value), oracle['strict']['error'].partition(': ')[2]
    assert plain(expected)[:60] in plain(said), said
    assert caught.value.help


def plain(text: str) -> str:
    """Without what differs between machines: search paths, file paths, object addresses."""
    text = re.sub(r'searching: \[.*?\]', 'searching: []', text)
    text = re.sub(r'(/|@)[\w./@-]*/', '', text)
    return re.sub(r' at 0x[0-9a-f]+', '', text).replace('"', '').strip()


def test_the_example_of_the_issue() -> None:
    """`from launch.actions import IfCondition` is an ImportError in ROS 2; we add where it lives."""
    with pytest.raises(edulaunch.LaunchFileError, match="cannot import name 'IfCondition' from 'launch.actions'") as caught:
        edulaunch.run(SEEDS / 'files' / 'launch_and_parameters' / 'conditional.launch.py')
    assert 'launch.conditions' in (caught.value.help or '')


def test_the_large_project_behaves_as_the_tutorial_says(workspace: Path) -> None:
    """The follower heads for the carrot, the mimic repeats its motion in world 2, rviz was asked for its view."""
    recording = edulaunch.run('launch_tutorial', 'launch_turtlesim.launch.py', duration_s=12.0, workspaces=[workspace])
    assert recording.parameters('/sim')['background_b'].value == 122
    assert recording.parameters('/turtlesim2/sim')['background_r'].value == 150
    frames = recording.frames_at(12.0)
    assert {child: frame.parent for child, frame in frames.items()} == {
        'turtle1': 'world',
        'turtle2': 'world',
        'carrot1': 'turtle1',
    }
    assert recording.series('/turtlesim2/turtle1/cmd_vel', 'linear.x') == recording.series('/turtle2/pose', 'linear_velocity')
    assert any('turtle_rviz.rviz' in log.message for log in recording.logs if log.process.startswith('rviz2'))
