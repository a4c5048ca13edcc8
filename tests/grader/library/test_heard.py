"""A node receives what another one publishes, whatever the topic is called; a line without a message earns nothing."""

from __future__ import annotations

from pathlib import Path

import pytest
from edugrade.turn import grade_turn

HEAD = """from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
"""
TALKER = "Node(package='demo_nodes_py', executable='talker', name='my_talker', remappings=[{}]),"
LISTENER = "Node(package='demo_nodes_py', executable='listener', name='my_listener', remappings=[{}]),"
NEWS = "('chatter', '/news')"
FIRST = """title: T
of: a.launch.py
runs: [{name: run, duration: 3, sends: {/chatter: {word: 3, at: {between: [1.2, 1.3]}}}}]
checks:
"""
SENDS = ', sends: {/chatter: {word: 3, at: {between: [1.2, 1.3]}}}'
RECEIVES = '{node: /my_listener, package: demo_nodes_py, from: {package: demo_nodes_py, executable: talker}}'
CLOCK = """import rclpy
from std_msgs.msg import String
rclpy.init()
node = rclpy.create_node('my_listener')
node.create_subscription(String, 'chatter', {}, 10)
timer = node.create_timer({}, lambda: node.get_logger().info('I heard: [x]'))
rclpy.spin(node)
"""


def judged(folder: Path, check: str, *actions: str, first: str = FIRST) -> tuple[str, str, str]:
    """What a turn with one check says of a launch file: the status, the reason and what was seen."""
    (folder / 'checks').mkdir()
    (folder / 'checks' / 'a.yaml').write_text(f'{first}  - {{{check}, points: 1}}\n')
    (folder / 'a.launch.py').write_text(HEAD + '\n'.join(f'        {action}' for action in actions) + '\n    ])\n')
    result = grade_turn('a', str(folder / 'checks' / 'a.yaml'), {}).results[-1]
    return result.status, result.reason or '', result.seen or ''


@pytest.mark.parametrize('pair', ['', NEWS])
def test_the_topic_may_have_any_name(tmp_path: Path, pair: str) -> None:
    found = judged(tmp_path, f'receives: {RECEIVES}', TALKER.format(pair), LISTENER.format(pair))
    assert found[0] == 'passed', found


def test_another_publisher_on_the_topic_of_the_listener_is_not_the_talker(tmp_path: Path) -> None:
    pub = "ExecuteProcess(cmd=['ros2', 'topic', 'pub', '/news', 'std_msgs/msg/String', '{data: x}']),"
    found = judged(tmp_path, f'receives: {RECEIVES}', TALKER.format(''), LISTENER.format(NEWS), pub)
    assert found == (
        'failed',
        '/my_listener receives no messages of talker of demo_nodes_py in the run with no arguments',
        '/my_listener subscribes to /news',
    )


def test_a_missing_node_is_named(tmp_path: Path) -> None:
    assert judged(tmp_path, f'receives: {RECEIVES}', TALKER.format(''))[:2] == ('failed', 'the node /my_listener is missing')


def test_a_missing_speaker_publishes_nothing(tmp_path: Path) -> None:
    status, reason, _ = judged(tmp_path, f'receives: {RECEIVES}', LISTENER.format(''))
    assert (status, 'receives no messages of talker of demo_nodes_py' in reason) == ('failed', True)


LOGS = "logs: {node: /my_listener, pattern: 'I heard', topic: /chatter}"


def test_lines_that_follow_messages_pass(tmp_path: Path) -> None:
    assert judged(tmp_path, LOGS, TALKER.format(''), LISTENER.format(''))[0] == 'passed'


@pytest.mark.parametrize(
    ('callback', 'period', 'reason'),
    [
        ('bool', '0.3', 'the line that /my_listener logs at'),  # more lines than messages
        ('bool', '1.001', 'the line of /my_listener for the message of 1.2'),  # as many, but not of the message of the grader
    ],
)
def test_lines_of_a_timer_are_not_paid(tmp_path: Path, callback: str, period: str, reason: str) -> None:
    (tmp_path / 'clock.py').write_text(CLOCK.format(callback, period))
    own = f"ExecuteProcess(cmd=['python3', {str(tmp_path / 'clock.py')!r}]),"
    status, said, _ = judged(tmp_path, LOGS, TALKER.format(''), own)
    assert (status, said.startswith(reason)) == ('failed', True), said


def test_a_node_without_a_subscription_receives_nothing(tmp_path: Path) -> None:
    status, said, _ = judged(tmp_path, LOGS.replace('/chatter', '/news'), TALKER.format(''), LISTENER.format(''))
    assert (status, said) == ('failed', '/my_listener does not subscribe to /news')


DEAF = """import rclpy
from rclpy.qos import QoSProfile, ReliabilityPolicy
from std_msgs.msg import String
rclpy.init()
node = rclpy.create_node('my_listener')
loud = node.create_publisher(String, 'chatter', QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT))
node.create_subscription(String, 'chatter', print, 10)
timer = node.create_timer(0.5, lambda: (loud.publish(String(data='x')), node.get_logger().info('I heard: [x]')))
rclpy.spin(node)
"""


def test_a_subscription_that_is_incompatible_with_each_publisher_hears_nothing(tmp_path: Path) -> None:
    (tmp_path / 'deaf.py').write_text(DEAF)
    program = f"ExecuteProcess(cmd=['python3', {str(tmp_path / 'deaf.py')!r}]),"
    status, reason, seen = judged(tmp_path, LOGS, program, first=FIRST.replace(SENDS, ''))
    assert (status, reason) == ('failed', '/my_listener receives no messages on /chatter in the run with no arguments')
    assert seen == 'the subscription of /my_listener is incompatible with /my_listener: RELIABILITY'
