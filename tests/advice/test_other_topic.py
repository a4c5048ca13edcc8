"""The action for two topics whose names differ names who uses the wrong name, and where a student writes the right one."""

from __future__ import annotations

from pathlib import Path

import pytest

import edulaunch
from edulaunch.advice import judge
from edulaunch.advice.rendering import rendered

START = """from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
"""
MIMIC = (
    "Node(package='turtlesim', executable='mimic', remappings=[('input/pose', '{}'), ('output/cmd_vel', '/turtle2/cmd_vel')]),\n"
)
SIM = "Node(package='turtlesim', executable='turtlesim_node'),\n"
PUBLISH = "ExecuteProcess(cmd=['ros2', 'topic', 'pub', '{}', 'geometry_msgs/msg/Twist']),\n"
TALK = "Node(package='demo_nodes_py', executable='talker', namespace='{}'),\n"
LISTEN = "Node(package='demo_nodes_py', executable='listener', remappings=[('chatter', '{}')]),\n"


def actions(folder: Path, *lines: str) -> dict[str, str]:
    file = folder / 'a.launch.py'
    file.write_text(START + ''.join(f'        {line}' for line in lines) + '    ])\n', encoding='utf-8')
    with edulaunch.Session() as session:
        session.launch(str(file))
        session.run(2.0)
        return {finding.rule: rendered(finding).do for finding in judge(session.recording())}


@pytest.mark.parametrize(
    ('lines', 'action'),
    [
        (
            [SIM, MIMIC.format('/turtl1/pose')],
            "write '/turtle1/pose' instead of '/turtl1/pose' in the remappings of /turtle_mimic",
        ),
        (
            [SIM, PUBLISH.format('/world/turtle1/cmd_vel')],
            "write '/turtle1/cmd_vel' instead of '/world/turtle1/cmd_vel' in the command of ros2-2",
        ),
        (
            [TALK.format('red'), TALK.format('blue'), LISTEN.format('/red/chatter/blue/chatter')],
            "write a comma after the string '/red/chatter': without it, Python joins this string to the next one",
        ),
        (
            [TALK.format('hall'), LISTEN.format('/chatter')],
            "use the same name in both nodes, or add remappings=[('/hall/chatter', '/chatter')] to the Node of /hall/talker",
        ),
    ],
    ids=['a remapping', 'a command', 'a missing comma', 'another namespace'],
)
def test_the_action_names_who_uses_the_wrong_name(tmp_path: Path, lines: list[str], action: str) -> None:
    assert actions(tmp_path, *lines)['messages.other-topic'] == action
