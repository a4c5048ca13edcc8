"""Each "Your turn" can be done as its hints say, and says what is missing until then."""

from __future__ import annotations

import json
import re
from collections.abc import Callable

import pytest
from edugrade.notebook import CheckReport
from edugrade.progress_file import ProgressFile
from edugrade.results import PASSED
from edugrade.rubrics.catalogue import load_rubric, rubrics_in

from tests.lessons.notebook import LESSONS, ORDER, Lesson, Walk

Begin = Callable[[str], Walk]
PACKAGE = 'my_ws/src/learning_tf2_py/'
NODES = PACKAGE + 'learning_tf2_py/'
CALL = re.compile(r"edulaunch\.check\('(\w+)'\)")


def turn(walk: Walk, cell: str = 'your-turn-check') -> list[str]:
    """What the check cell says about each task: done, or not yet."""
    walk.run(cell)
    found = walk.names['_']
    assert isinstance(found, CheckReport), found
    own = [result for result in found.report.results if result.name not in ('launches', 'repeats')]
    return ['done' if result.status == PASSED else 'not yet' for result in own]


def test_every_rubric_of_a_turn_is_asked_for_once_and_can_be_read() -> None:
    rubrics = rubrics_in(str(LESSONS / 'checks'))
    asked = [name for lesson in ORDER for cell in Lesson(lesson).code for name in CALL.findall(cell.source)]
    assert sorted(asked) == sorted(rubrics)
    assert all(load_rubric(path).of or load_rubric(path).names for path in rubrics.values())


def test_no_cell_says_done_by_itself() -> None:
    cells = [(lesson, cell.id) for lesson in ORDER for cell in Lesson(lesson).code if "'done'" in cell.source]
    assert cells == []


@pytest.mark.parametrize('lesson', ['00_python', '01_first_launch', '02_names', '03_parameters', '11_time', '16_silent_systems'])
def test_what_is_handed_out_is_not_done(walk: Begin, lesson: str) -> None:
    student = walk(lesson)
    student.run_all(until='your-turn-check')
    if lesson == '00_python':
        student.run('turn')
    assert 'not yet' in turn(student)
    assert json.dumps(ProgressFile(str(student.folder)).exercises, default=vars).count('"attempts": 1') == 1


def test_lesson_0_asks_for_a_counter(walk: Begin) -> None:
    student = walk('00_python')
    student.run('set-up')
    student.run('turn')
    assert turn(student) == ['not yet', 'not yet', 'not yet']
    student.names['three'] = lambda callback: 1 / 0
    assert turn(student) == ['not yet', 'not yet', 'not yet']
    student.names['three'] = lambda callback: [callback() for _ in range(3)]
    assert turn(student) == ['not yet', 'not yet', 'done']
    del student.names['three']
    assert turn(student) == ['not yet', 'not yet', 'not yet']


def test_lesson_1_asks_for_a_name_and_a_colour(walk: Begin) -> None:
    student = walk('01_first_launch')
    student.run_all(until='your-turn-check')
    assert turn(student) == ['not yet'] * 4
    student.edit('my_launch/square.launch.py', "name='driver'", "name='artist'")
    assert turn(student) == ['done', 'not yet', 'not yet', 'not yet']
    red = "name='sim', parameters=[{'background_r': '200', 'background_g': 30, 'background_b': 30}]"
    student.edit('my_launch/square.launch.py', "name='sim'", red)
    assert turn(student) == ['done', 'not yet', 'not yet', 'not yet']  # a text is no number: nothing is set, nothing raised
    student.edit('my_launch/square.launch.py', "'200'", '200')
    assert turn(student) == ['done'] * 4


def test_lesson_2_asks_for_a_station(walk: Begin) -> None:
    student = walk('02_names')
    student.run_all(until='your-turn-check')
    node = "        Node(package='demo_nodes_py', executable='{}', {}),\n"
    listeners = [
        node.format('listener', f"name='{name}', remappings=[('chatter', '/radio/chatter')]") for name in ('car', 'home')
    ]
    text = ''.join([node.format('talker', "name='station', namespace='radio'"), *listeners])
    student.edit('my_launch/radio.launch.py', '[\n    ]', f'[\n{text}    ]')
    assert turn(student) == ['done'] * 5
    student.edit(
        'my_launch/radio.launch.py', "name='home', remappings=[('chatter', '/radio", "name='home', remappings=[('chatter', 'radi"
    )
    assert turn(student) == ['done', 'done', 'done', 'done', 'not yet']


def test_lesson_3_asks_for_two_colours(walk: Begin) -> None:
    student = walk('03_parameters')
    student.run_all(until='your-turn-check')
    block = '{}:\n  ros__parameters:\n    background_r: {}\n    background_g: {}\n'
    student.write('my_launch/mine.yaml', '/**:\n  ros__parameters:\n    background_b: 30\n' + block.format('/sim', 220, 0))
    assert turn(student) == ['done', 'done', 'done', 'not yet', 'not yet', 'done']


@pytest.mark.parametrize(
    ('asked', 'others', 'result'),
    [
        ('now - Duration(seconds=2.0)', "if not buffer.can_transform('world', 'turtle1', time):\n        return\n", ['done'] * 3),
        (
            'now - Duration(seconds=1.0)',
            "if not buffer.can_transform('world', 'turtle1', time):\n        return\n",
            ['done', 'done', 'not yet'],
        ),
        ('now - Duration(seconds=2.0)', 'pass\n', ['not yet'] * 3),
    ],
)
def test_lesson_11_asks_for_the_past(walk: Begin, asked: str, others: str, result: list[str]) -> None:
    student = walk('11_time')
    student.run_all(until='your-turn-check')
    ask = student.lesson.files()['my_launch/ask.py']
    head, tail = ask.split('def ask():')[0], ask.split('rclpy.init()')[1].replace("'ask'", "'lag'")
    body = f'    now = node.get_clock().now()\n    time = {asked}\n    {others}'
    look = "    place = buffer.lookup_transform('world', 'turtle1', time).transform.translation\n"
    say = "    node.get_logger().info(f'{place.x:.2f} {place.y:.2f}')\n\n\n"
    student.write('my_launch/lag.py', f'{head}def ask():\n{body}{look}{say}rclpy.init(){tail}')
    assert turn(student) == result


def test_lesson_8_asks_for_a_place_and_a_direction(walk: Begin) -> None:
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
def test_lesson_9_asks_for_a_nearer_follower(walk: Begin, gain: str, period: str, result: str) -> None:
    student = walk('09_broadcaster_and_listener')
    student.run_all(until='your-turn-check')
    student.edit(NODES + 'steering.py', '0.5 * hypot', f'{gain} * hypot')
    student.edit(NODES + 'turtle_tf2_listener.py', 'create_timer(1.0', f'create_timer({period}')
    assert turn(student) == ['done', result]


SECONDS = 'seconds, _ = self.get_clock().now().seconds_nanoseconds()'
OFFSET = 'x, y = 10 * sin(seconds * pi), 10 * cos(seconds * pi)'


@pytest.mark.parametrize(
    ('seconds', 'offset', 'result'),
    [
        (SECONDS, OFFSET, ['done', 'not yet', 'not yet', 'not yet']),
        (SECONDS, 'x, y = 2 * sin(seconds * pi / 5), 2 * cos(seconds * pi / 5)', ['done', 'done', 'not yet', 'not yet']),
        (
            'seconds = self.get_clock().now().nanoseconds / 1e9',
            'x, y = 2 * sin(seconds * pi), 2 * cos(seconds * pi)',
            ['done', 'done', 'not yet', 'not yet'],
        ),
        (
            'angle = 2 * pi * self.get_clock().now().nanoseconds / 1e9 / 10',
            'x, y = 2 * cos(angle), 2 * sin(angle)',
            ['done', 'done', 'done', 'done'],
        ),
        (
            'angle = 2 * pi * self.get_clock().now().nanoseconds / 1e9 / 5',
            'x, y = 2 * cos(angle), 2 * sin(angle)',
            ['done', 'done', 'done', 'not yet'],
        ),
    ],
)
def test_lesson_10_asks_for_a_round_carrot(walk: Begin, seconds: str, offset: str, result: list[str]) -> None:
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


def test_lesson_13_asks_for_a_third_world(walk: Begin) -> None:
    student = walk('13_large_project')
    student.run_all(until='your-turn-check')
    student.run('set-up')
    assert turn(student) == ['not yet'] * 4
    launch = 'my_ws/src/launch_tutorial/launch/'
    student.write(launch + 'mimic.launch.py', MIMIC)
    student.edit(launch + 'launch_turtlesim.launch.py', "part('mimic'),", PARTS)
    assert turn(student) == ['done'] * 4
    other = "leader='/turtlesim2/turtle1', copier='/turtlesim3"
    student.edit(launch + 'launch_turtlesim.launch.py', other, other.replace('/turtlesim2/turtle1', '/turtlesim1/turtle1', 1))
    assert turn(student) == ['done', 'done', 'not yet', 'not yet']


KEPT = 'QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)'


def test_lesson_18_asks_for_a_notice_that_stays_and_a_reader_that_asks_for_it(walk: Begin) -> None:
    student = walk('18_real_network')
    student.run_all(until='your-turn-check')
    assert turn(student) == ['not yet']
    student.edit('my_launch/notice.py', "'notice', QoSProfile(depth=1))", f"'notice', {KEPT})")
    assert turn(student) == ['not yet'], 'the harbour alone'
    student.edit('my_launch/notice.py', 'qos = QoSProfile(depth=1)\n', f'qos = {KEPT}\n')
    assert turn(student) == ['done']
    student.edit('my_launch/notice.py', f"'notice', {KEPT})", "'notice', QoSProfile(depth=1))")
    assert turn(student) == ['not yet'], 'the reader alone'


HANDLERS = """from launch import LaunchDescription
from launch.actions import RegisterEventHandler, Shutdown, TimerAction
from launch.event_handlers import OnProcessExit, OnProcessStart
from launch_ros.actions import Node


def generate_launch_description():
    sim = Node(package='turtlesim', executable='turtlesim_node', name='sim')
    square = Node(package='turtlesim', executable='draw_square')
    late = TimerAction(period=3.0, actions=[Node(package='turtlesim', executable='mimic', name='copy')])
    return LaunchDescription([
        RegisterEventHandler(OnProcessStart(target_action=sim, on_start=[square, late])),
        RegisterEventHandler(OnProcessExit(target_action=square, on_exit=[Shutdown()])),
        sim,
    ])
"""


def test_lesson_5_takes_an_end_in_a_handler_and_none_in_a_comment(walk: Begin) -> None:
    student = walk('05_events')
    student.run_all(until='your-turn-check')
    student.write('my_launch/careful.launch.py', HANDLERS)
    assert turn(student) == ['done'] * 3
    student.write('my_launch/careful.launch.py', HANDLERS.replace('[Shutdown()])),', '[])),  # Shutdown()'))
    assert turn(student).count('not yet') == 1


def test_lesson_9_looks_at_the_broadcaster_and_not_at_the_static_one(walk: Begin) -> None:
    student = walk('09_broadcaster_and_listener')
    student.run_all(until='improve-check')
    assert (student.folder / NODES / 'static_turtle_tf2_broadcaster.py').is_file()
    assert turn(student, 'improve-check').count('not yet') == 1
