"""Each "Your turn" can be done as its hints say, and says what is missing until then."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from tests.lessons.notebook import Walk

Begin = Callable[[str], Walk]
PACKAGE = 'my_ws/src/learning_tf2_py/'
NODES = PACKAGE + 'learning_tf2_py/'


def turn(walk: Walk) -> list[str]:
    """What the check cell says about each task: done, or not yet."""
    return ['done' if ' done' in f' {line}' else 'not yet' for line in walk.run('your-turn-check').splitlines()]


def test_lesson_1_asks_for_a_name_and_a_colour(walk: Begin) -> None:
    student = walk('01_first_launch')
    student.run_all(until='your-turn-check')
    assert turn(student) == ['not yet', 'not yet']
    student.edit('my_launch/square.launch.py', "name='driver'", "name='artist'")
    assert turn(student) == ['done', 'not yet']
    student.edit(
        'my_launch/square.launch.py',
        "name='sim'",
        "name='sim', parameters=[{'background_r': 200, 'background_g': 30, 'background_b': 30}]",
    )
    assert turn(student) == ['done', 'done']


def test_lesson_2_asks_for_a_place_and_a_direction(walk: Begin) -> None:
    student = walk('08_static_broadcaster')
    student.run_all(until='your-turn-check')
    assert turn(student) == ['not yet', 'not yet']
    student.edit(PACKAGE + 'launch/thing.launch.py', "'--x', '1', '--y', '0'", "'--x', '0', '--y', '-1'")
    assert turn(student) == ['done', 'not yet']
    student.edit(PACKAGE + 'launch/thing.launch.py', "'--yaw', '0'", "'--yaw', '3.1415927'")
    assert turn(student) == ['done', 'done']


@pytest.mark.parametrize(
    ('gain', 'period', 'result'),
    [
        ('0.5', '0.1', 'not yet'),
        ('1.5', '1.0', 'done'),
        ('1.5', '0.1', 'done'),
        ('2.0', '1.0', 'not yet'),
        ('2.0', '0.1', 'done'),
    ],
)
def test_lesson_3_asks_for_a_nearer_follower(walk: Begin, gain: str, period: str, result: str) -> None:
    student = walk('09_broadcaster_and_listener')
    student.run_all(until='your-turn-check')
    student.edit(NODES + 'steering.py', '0.5 * hypot', f'{gain} * hypot')
    student.edit(NODES + 'turtle_tf2_listener.py', 'create_timer(1.0', f'create_timer({period}')
    assert turn(student) == [result]


SECONDS = 'seconds, _ = self.get_clock().now().seconds_nanoseconds()'
OFFSET = 'x, y = 10 * sin(seconds * pi), 10 * cos(seconds * pi)'


@pytest.mark.parametrize(
    ('seconds', 'offset', 'result'),
    [
        (SECONDS, OFFSET, ['not yet', 'not yet', 'not yet']),
        (SECONDS, 'x, y = 2 * sin(seconds * pi / 5), 2 * cos(seconds * pi / 5)', ['done', 'not yet', 'not yet']),
        (
            'seconds = self.get_clock().now().nanoseconds / 1e9',
            'x, y = 2 * sin(seconds * pi), 2 * cos(seconds * pi)',
            ['done', 'not yet', 'not yet'],
        ),
        (
            'angle = 2 * pi * self.get_clock().now().nanoseconds / 1e9 / 10',
            'x, y = 2 * cos(angle), 2 * sin(angle)',
            ['done', 'done', 'done'],
        ),
        (
            'angle = 2 * pi * self.get_clock().now().nanoseconds / 1e9 / 5',
            'x, y = 2 * cos(angle), 2 * sin(angle)',
            ['done', 'done', 'not yet'],
        ),
    ],
)
def test_lesson_4_asks_for_a_round_carrot(walk: Begin, seconds: str, offset: str, result: list[str]) -> None:
    student = walk('10_carrots')
    student.run_all(until='your-turn-check')
    student.edit(NODES + 'dynamic_frame_tf2_broadcaster.py', SECONDS, seconds)
    student.edit(NODES + 'dynamic_frame_tf2_broadcaster.py', OFFSET, offset)
    assert turn(student) == result


MIMIC = """from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('leader'),
        DeclareLaunchArgument('copier'),
        Node(package='turtlesim', executable='mimic', name='mimic', remappings=[
            ('input/pose', [LaunchConfiguration('leader'), '/pose']),
            ('output/cmd_vel', [LaunchConfiguration('copier'), '/cmd_vel']),
        ]),
    ])
"""
PARTS = """part('mimic', leader='/turtle2', copier='/turtlesim2/turtle1'),
        GroupAction([
            PushROSNamespace('turtlesim3'),
            part('turtlesim_world_2'),
            part('mimic', leader='/turtlesim2/turtle1', copier='/turtlesim3/turtle1'),
        ]),"""


def test_lesson_5_asks_for_a_third_world(walk: Begin) -> None:
    student = walk('13_large_project')
    student.run_all(until='your-turn-check')
    student.run('set-up')
    assert turn(student) == ['not yet', 'not yet', 'not yet']
    launch = 'my_ws/src/launch_tutorial/launch/'
    student.write(launch + 'mimic.launch.py', MIMIC)
    student.edit(launch + 'launch_turtlesim.launch.py', "part('mimic'),", PARTS)
    assert turn(student) == ['done', 'done', 'done']
