"""Each cell that looks at what a student wrote says "not yet" of the gap, and "done" of what the hints lead to: lessons 9 to 17."""

from __future__ import annotations

from collections.abc import Callable
from math import dist
from pathlib import Path

import pytest

from edulaunch.desk.notebook.terminal import CellTerminal
from tests.lessons.notebook import LESSONS, Walk
from tests.lessons.student import Student
from tests.lessons.test_your_turn import turn

Begin = Callable[[str], Walk]
PACKAGE = 'my_ws/src/learning_tf2_py/'
NODES = PACKAGE + 'learning_tf2_py/'
FLEET = 'my_ws/src/fleet/'


def checkpoint(path: str) -> str:
    return (LESSONS / 'checkpoints' / 'fleet' / path).read_text('utf-8')


GAPS: list[tuple[str, str, list[tuple[str, str, str]]]] = [
    (
        '10_carrots',
        'behind-check',
        [
            (NODES + 'fixed_frame_tf2_broadcaster.py', 'translation.x = 0.0', 'translation.x = -1.0'),
            (NODES + 'fixed_frame_tf2_broadcaster.py', 'translation.y = 2.0', 'translation.y = 0.0'),
        ],
    ),
    ('10_carrots', 'carrot-check', [(PACKAGE + 'launch/carrot.launch.py', '', checkpoint('launch/carrot.launch.py'))]),
    (
        '11_time',
        'wait-run',
        [
            ('my_launch/ask.py', "'turtle1', time)", "'turtle1', time, timeout=Duration(seconds=0.1))"),
            ('my_launch/ask.py', 'spin(node)', 'spin(node, MultiThreadedExecutor())'),
            ('my_launch/ask.py', 'import rclpy\n', 'import rclpy\nfrom rclpy.executors import MultiThreadedExecutor\n'),
        ],
    ),
    ('11_time', 'fleet-check', [(NODES + 'watching.py', 'info(text)', 'info(text, throttle_duration_sec=2.0)')]),
    (
        '12_urdf',
        'moving-run',
        [
            (
                'my_launch/moving.launch.py',
                '# TODO: the positions of the joints',
                "Node(package='joint_state_publisher', executable='joint_state_publisher'),",
            )
        ],
    ),
    (
        '13_large_project',
        'fixed-check',
        [
            (
                'my_ws/src/launch_tutorial/launch/fixed_broadcaster.launch.py',
                "name='fixed_broadcaster',  # TODO: [the prefix, this]",
                "name=[LaunchConfiguration('node_prefix'), 'fixed_broadcaster'],",
            )
        ],
    ),
    ('14_services', 'newcomer-check', [('my_launch/newcomer.py', '', checkpoint('fleet/newcomer.py'))]),
    ('15_bags', 'black-box-check', [('my_launch/black_box.launch.py', '', checkpoint('launch/black_box.launch.py'))]),
    (
        '16_silent_systems',
        'three-check',
        [
            (
                'my_launch/scan.py',
                "message: mapper.get_logger().info('a scan'), 5)",
                "message: mapper.get_logger().info('a scan'), qos_profile_sensor_data)",
            )
        ],
    ),
    (
        '16_silent_systems',
        'chain-check',
        [
            ('my_launch/chain.launch.py', "'input_clouds'", "'input_cloud'"),
            ('my_launch/chain.launch.py', "'detection'", "'detections'"),
        ],
    ),
]


@pytest.mark.parametrize(('lesson', 'check', 'edits'), GAPS, ids=[check for _, check, _ in GAPS])
def test_the_gap_is_not_yet_and_what_the_hints_lead_to_is_done(
    walk: Begin, lesson: str, check: str, edits: list[tuple[str, str, str]]
) -> None:
    student = walk(lesson)
    student.run_all(until=check)
    student.run('set-up')
    assert 'not yet' in turn(student, check)
    for path, old, new in edits:
        student.write(path, new) if not old else student.edit(path, old, new)
    assert set(turn(student, check)) == {'done'}


ON_TIMER = """goal = self.watcher.find(self.target, seen_from=self.me)
        if goal is not None:
            self.publisher.publish(steer(goal.x, goal.y))
"""
PARTS = """Node(package='turtle_tf2_py', executable='turtle_tf2_broadcaster', name=['broadcaster_', me],
             parameters=[{'turtlename': me}]),
        Node(package='fleet', executable='follower', name=['follower_', me],
             parameters=[{'me': me, 'target': ['carrot_', leader]}]),
"""
AFTER = 'RegisterEventHandler(OnProcessStart(target_action=sim, on_start=[follower(number) for number in (2, 3, 4)])), sim,'


def test_the_fleet_is_built_of_the_parts_of_the_lessons_before(walk: Begin, monkeypatch: pytest.MonkeyPatch) -> None:
    student = walk('17_fleet')
    monkeypatch.chdir(student.folder)
    student.run('set-up')
    CellTerminal(lambda stream, text: None).ros2('pkg create fleet --build-type ament_python --destination-directory my_ws/src')
    student.run('folders')
    student.write(NODES + 'steering.py', checkpoint('fleet/steering.py').replace('4.0', '5.0'))
    assert student.run('folders').splitlines()[0].split() == ['fleet/steering.py', 'yours']
    student.run_all(until='one-check')
    assert 'not yet' in turn(student, 'one-check')
    student.edit(
        FLEET + 'fleet/follower.py', 'pass  # TODO: find the target, as seen from self.me; publish what steer returns\n', ON_TIMER
    )
    student.edit(
        FLEET + 'launch/follower.launch.py', "# TODO: the broadcaster, and the node, which follows ['carrot_', leader]\n", PARTS
    )
    assert set(turn(student, 'one-check')) == {'done'}
    top = FLEET + 'launch/fleet.launch.py'
    student.write(top, dict([student.lesson['top-py'].file or ('', '')])['my_ws/src/fleet/launch/fleet.launch.py'])
    student.edit(top, '*[follower(number) for number in (2, 3, 4)], sim,', AFTER)
    student.edit(
        top,
        'from launch.conditions',
        'from launch.actions import RegisterEventHandler\nfrom launch.event_handlers import OnProcessStart\nfrom launch.conditions',
    )
    student.run('fleet-run')
    fleet = student.names['fleet']
    kept = {node.name for node in fleet.nodes if not node.name.startswith(('/_ros2cli', '/newcomer'))}
    assert len(kept) == 11
    places = fleet.frames_at(25.0)
    gaps = [dist(places[f'turtle{n}'].translation, places[f'turtle{n - 1}'].translation) for n in (2, 3, 4)]
    assert all(1.5 < gap < 1.8 for gap in gaps)


def test_the_way_that_a_bag_tells_can_be_right(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Its poses come from the player of the bag, and not from turtlesim."""
    monkeypatch.setenv('USER', 'student')
    cells = 'set-up record-py record-run stop way-py way-launch way-run'
    right = {'way-py': [['way += 0.0', 'way += hypot(pose.x - last.x, pose.y - last.y)']]}
    assert 'way: all passed' in Student('15_bags', tmp_path).walk(cells, right)
