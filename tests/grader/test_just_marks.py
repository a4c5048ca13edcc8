"""Real submissions, run and graded: unusual right answers get all points, near misses and claims do not."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import pytest
from edugrade.grading import grade, plan_work
from edugrade.results import Report
from edugrade.submission import Submission

SOLUTIONS = Path(__file__).parents[2] / 'solutions'
CIRCLE, FOLLOW, STATIC = ((SOLUTIONS / f'{name}.launch.py').read_text() for name in ('circle', 'follow', 'static_frame'))
RUN = "        ExecuteProcess(cmd=['ros2', 'run', 'turtlesim', 'turtlesim_node']),\n"
SHELL = "        ExecuteProcess(cmd=['ros2 run turtlesim turtlesim_node'], shell=True),\n"
SIM = "        Node(package='turtlesim', executable='turtlesim_node', name='sim'),\n"
SQUARE = "        Node(package='turtlesim', executable='draw_square', condition=IfCondition(move)),\n"
WITH_PROCESS = ('import DeclareLaunchArgument', 'import DeclareLaunchArgument, ExecuteProcess')
FIRST_CIRCLE, FIRST_STATIC = ('        DeclareLaunchArgument(\n', "        DeclareLaunchArgument('height'")
PUBLISH = "        ExecuteProcess(cmd=['ros2', 'topic', 'pub', {}]),\n"
LISTENER = "executable='turtle_tf2_listener'"
PARK = """        TimerAction(period=3.0, actions=[ExecuteProcess(cmd=['ros2', 'service', 'call', '/spawn', 'turtlesim/srv/Spawn',
            '{x: 6.5, y: 6.5, name: turtle2}'])]),
"""


def changed(text: str, *changes: tuple[str, str]) -> str:
    for old, new in changes:
        assert old in text, old
        text = text.replace(old, new)
    return text


def without_listener(text: str) -> str:
    """The follower's launch file in which turtle2 is only put somewhere."""
    start = text.index(LISTENER)
    begin, end = text.rindex('        Node(', 0, start), text.index('        ),\n', start) + len('        ),\n')
    return changed(
        text[:begin] + PARK + text[end:],
        ('import DeclareLaunchArgument', 'import DeclareLaunchArgument, ExecuteProcess, TimerAction'),
    )


def late(text: str) -> str:
    """All Nodes of a launch file, begun in the last instant of a run of 5 s."""
    return changed(
        text,
        (
            'from launch_ros.actions import Node',
            'from launch.actions import TimerAction\nfrom launch_ros.actions import Node as _Node\n\n\ndef Node(**words):\n    return TimerAction(period=4.9, actions=[_Node(**words)])\n',
        ),
    )


RIGHT = {
    'a default of another spelling': ('circle', changed(CIRCLE, ("'1.0'", "'1.00'"))),
    'a default in two parts': ('circle', changed(CIRCLE, ("default_value='1.0'", "default_value=['1', '.0']"))),
    'turtlesim by ros2 run': ('follow', changed(FOLLOW, (SIM, RUN), WITH_PROCESS)),
    'turtlesim by a shell': ('follow', changed(FOLLOW, (SIM, SHELL), WITH_PROCESS)),
    'draw_square before turtlesim': ('follow', changed(FOLLOW, (SIM, ''), (SQUARE, SQUARE + SIM))),
}
# Each with a check that must not pass.
WRONG = {
    'text on the odometry': (
        'circle',
        'world_is_there',
        changed(CIRCLE, WITH_PROCESS, (FIRST_CIRCLE, PUBLISH.format("'/odom', 'std_msgs/msg/String', 'data: x'") + FIRST_CIRCLE)),
    ),
    'an odometry of its own': (
        'circle',
        'world_is_there',
        changed(CIRCLE, WITH_PROCESS, (FIRST_CIRCLE, PUBLISH.format("'/odom', 'nav_msgs/msg/Odometry'") + FIRST_CIRCLE)),
    ),
    'a velocity that is not a number': (
        'follow',
        'standing_leader_is_reached',
        changed(
            FOLLOW,
            WITH_PROCESS,
            (SIM, SIM + PUBLISH.format("'/turtle2/cmd_vel', 'geometry_msgs/msg/Twist', '{linear: {x: .nan}}'")),
        ),
    ),
    'another program before the node': (
        'circle',
        'node_is_started',
        changed(CIRCLE, ("executable='param_circle.py',", "executable='param_circle.py', prefix='python3 -c pass',")),
    ),
    'frames in the last instant': ('static_frame', 'laser_is_on_tf', late(STATIC)),
    'a turtle that is parked in the middle': ('follow', 'moving_leader_is_followed', without_listener(FOLLOW)),
}


@cache
def reports(folder: Path) -> dict[str, Report]:
    works = []
    cases = {
        **{name: (kind, text) for name, (kind, text) in RIGHT.items()},
        **{name: (kind, text) for name, (kind, _, text) in WRONG.items()},
    }
    for number, (kind, text) in enumerate(cases.values()):
        file = folder / str(number) / f'{kind}.launch.py'
        file.parent.mkdir()
        file.write_text(text)
        works.append(plan_work(Submission(str(file))))
    return dict(zip(cases, grade(works), strict=True))


@pytest.fixture(scope='module')
def graded(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Report]:
    return reports(tmp_path_factory.mktemp('submissions'))


@pytest.mark.parametrize('name', RIGHT)
def test_an_unusual_right_answer_gets_all_points(graded: dict[str, Report], name: str) -> None:
    report = graded[name]
    assert (report.earned, [result.reason for result in report.results if result.reason]) == (12, [])


@pytest.mark.parametrize('name', WRONG)
def test_a_claim_is_no_result(graded: dict[str, Report], name: str) -> None:
    report = graded[name]
    (result,) = [result for result in report.results if result.name == WRONG[name][1]]
    assert (result.earned, result.status in ('failed', 'not_run')) == (0, True), result
    assert report.earned is not None
    assert report.earned < 12
