"""`edugrade decoys` over a course with a rubric that looks at names, and one that looks at what happens."""

from __future__ import annotations

from pathlib import Path

import pytest
from edugrade.decoys.command import main, pay

from edulaunch.errors import UnusableInput

pytestmark = pytest.mark.processes
SOLUTION = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node', name='sim'),
        Node(package='turtlesim', executable='draw_square', name='driver'),
    ])
"""
ENTRY = """\
[[exercise]]
file = '{name}.launch.py'
title = 'Drive'
points = 4
hints = []
"""
RUNS = 'title: Drive\nruns: [{name: one, duration: 2}]\nchecks:\n'
NAMES = RUNS + '  - {name: names, nodes: {are: [/sim, /driver]}, points: 4}\n'
BEHAVIOUR = RUNS + '  - {name: moves, travels: {turtle: turtle1, at_least: 0.5, driver: turtlesim draw_square}, points: 4}\n'


@pytest.fixture
def course(tmp_path: Path) -> Path:
    for folder in ('exercises', 'solutions', 'rubrics'):
        (tmp_path / folder).mkdir()
    for name, rubric in (('named', NAMES), ('driven', BEHAVIOUR)):
        (tmp_path / 'solutions' / f'{name}.launch.py').write_text(SOLUTION)
        (tmp_path / 'rubrics' / f'{name}.yaml').write_text(rubric)
    (tmp_path / 'course.toml').write_text(ENTRY.format(name='named') + ENTRY.format(name='driven'))
    return tmp_path


def test_names_are_paid_for_by_one_rubric_and_not_by_the_other(course: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main([str(course)]) == 1
    lines = capsys.readouterr().out.splitlines()
    assert [line.split()[:2] + line.split()[-2:] for line in lines if line.startswith(('named', 'driven'))] == [
        ['named', 'names', 'TOO', 'MUCH'],
        ['named', 'replay', 'TOO', 'MUCH'],
        ['named', 'swapped', 'TOO', 'MUCH'],
        ['driven', 'names', '4', 'ok'],
        ['driven', 'replay', '4', 'ok'],
        ['driven', 'swapped', '4', 'ok'],
    ]
    assert lines[-1] == '6 decoys; 3 of them get more points than their rubric allows'


def test_an_exercise_that_is_not_there_is_named(course: Path) -> None:
    with pytest.raises(UnusableInput, match='the course has no exercise other'):
        list(pay(str(course), ['other']))
