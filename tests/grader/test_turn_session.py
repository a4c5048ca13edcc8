"""What a turn hides from the student: a program that cannot start, a program that ends, and a driver that is a command."""

from __future__ import annotations

from pathlib import Path

import pytest
from edugrade.turn import grade_turn

HEAD = """from launch import LaunchDescription
from launch.actions import ExecuteProcess, RegisterEventHandler, Shutdown, TimerAction
from launch.event_handlers import OnProcessStart
from launch_ros.actions import Node


def generate_launch_description():
    sim = Node(package='turtlesim', executable='turtlesim_node', name='sim')
    square = Node(package='turtlesim', executable='draw_square'{more})
    return LaunchDescription([{actions}])
"""
RUBRIC = """
from edugrade import Failure, Rubric, Scenario, check
from edugrade.library.identity import nodes_of

@check(points=1)
def waits(run):
    'draw_square waits for the simulator'
    if nodes_of(run['without'], 'turtlesim', 'draw_square'):
        raise Failure('it does not wait')

@check(points=1)
def ends(run):
    'The launch ends with draw_square'
    if run['run'].processes[0].ended_s != 2.0:
        raise Failure('the launch continues')

RUBRIC = Rubric(
    title='T', of='a.launch.py', ended='draw_square', checks=[waits, ends],
    scenarios=lambda random: [Scenario('run', {}, 2.0), Scenario('without', {}, 2.0, fails=['turtlesim_node'])],
)
"""
DRIVEN = """title: T
of: a.launch.py
runs: [{name: run, duration: 3}]
checks:
  - {name: drives, travels: {turtle: turtle1, at_least: 1, driver: ros2 topic pub}, points: 1}
"""
HANDLER = 'RegisterEventHandler(OnProcessStart(target_action=sim, on_start=[square])), sim'
PUB = "ExecuteProcess(cmd=['ros2', 'topic', 'pub', '-r', '10', '/turtle1/cmd_vel', 'geometry_msgs/msg/Twist', '{linear: {x: 1.0}}'])"


def statuses(folder: Path, rubric: str, actions: str, more: str = '') -> list[str]:
    (folder / 'checks').mkdir()
    path = folder / 'checks' / ('a.yaml' if rubric.startswith('title') else 'a.py')
    path.write_text(rubric)
    (folder / 'a.launch.py').write_text(HEAD.format(actions=actions, more=more))
    return [result.status for result in grade_turn('a', str(path), {}).results[1:]]


@pytest.mark.parametrize(
    ('actions', 'more', 'wanted'),
    [
        (HANDLER, ', on_exit=[Shutdown()]', ['passed', 'passed']),
        ('sim, square', ', on_exit=[Shutdown()]', ['failed', 'passed']),
        (HANDLER, '', ['passed', 'failed']),
        (HANDLER + ', TimerAction(period=1.0, actions=[Shutdown()])', '', ['passed', 'failed']),
    ],
)
def test_what_waits_for_a_start_or_an_end_is_seen(tmp_path: Path, actions: str, more: str, wanted: list[str]) -> None:
    assert statuses(tmp_path, RUBRIC, actions, more) == wanted


@pytest.mark.parametrize(('actions', 'wanted'), [(f'sim, {PUB}', 'passed'), ('sim, square', 'failed')])
def test_a_driver_can_be_a_command(tmp_path: Path, actions: str, wanted: str) -> None:
    assert statuses(tmp_path, DRIVEN, actions) == [wanted]
