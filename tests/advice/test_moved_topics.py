"""A topic that a remapping of the other node moved: the advice names this remapping, and no similar topic."""

from __future__ import annotations

from pathlib import Path

import pytest

import edulaunch
from edulaunch.advice import judge
from edulaunch.advice.rendering import rendered

FILE = """from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node', remappings=[('{old}', '{new}')]),
        ExecuteProcess(cmd=['ros2', 'topic', 'pub', '{topic}', 'geometry_msgs/msg/Twist', '{{linear: {{x: 0.3}}}}']),
        ExecuteProcess(cmd=['ros2', 'service', 'call', '/spawn', 'turtlesim/srv/Spawn', '{{name: turtle2}}']),
    ])
"""


def advice(folder: Path, **words: str) -> dict[str, str]:
    file = folder / 'a.launch.py'
    file.write_text(FILE.format(**words))
    with edulaunch.Session() as session:
        session.launch(str(file))
        session.run(2.0)
        return {finding.rule: rendered(finding).do for finding in judge(session.recording())}


@pytest.mark.parametrize(('old', 'topic'), [('turtle2/cmd_vel', '/turtle2/cmd_vel'), ('/turtle1/cmd_vel', '/turtle1/cmd_vel')])
def test_the_remapping_that_moved_the_subscription_is_named(tmp_path: Path, old: str, topic: str) -> None:
    found = advice(tmp_path, old=old, new='/hand/cmd_vel', topic=topic)
    assert 'messages.other-topic' not in found
    assert found['messages.nobody-listens'].startswith(
        f'remove the remapping of {topic} to /hand/cmd_vel from /turtlesim, or add the same '
    )


def test_a_remapping_of_another_topic_is_not_the_reason(tmp_path: Path) -> None:
    found = advice(tmp_path, old='turtle1/pose', new='/hand/pose', topic='/turtle1/cmd_vell')
    action = "write '/turtle1/cmd_vel' instead of '/turtle1/cmd_vell' in the command of ros2-2"
    assert found['messages.other-topic'] == action
