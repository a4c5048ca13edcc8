"""The defaults of parameters that a launch file changed."""

from __future__ import annotations

from pathlib import Path

import pytest

import edulaunch
from edulaunch.desk.view.defaults import defaults_of
from edulaunch.desk.view.replay import RecordingSource, timeline_of
from edulaunch.engine.packages import Index

LAUNCH = """
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node', name='sim', parameters=[{'background_r': 200}]),
        Node(package='turtlesim', executable='turtlesim_node', name='other'),
    ])
"""


def test_the_defaults_of_a_program_of_edulaunch(tmp_path: Path) -> None:
    file = tmp_path / 'my.launch.py'
    file.write_text(LAUNCH)
    found = {(node, name): value for node, name, value in timeline_of(edulaunch.run(file, duration_s=0.2))['defaults']}
    assert found['/sim', 'background_r'] == 69 and found['/sim', 'background_g'] == 86
    assert not any(node == '/other' for node, _ in found)


def test_without_changes_there_is_nothing_to_say() -> None:
    assert 'defaults' not in timeline_of(edulaunch.run('turtlesim', 'multisim.launch.py', duration_s=0.2))


def test_the_defaults_of_a_student_are_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    program = tmp_path / 'speed.py'
    program.write_text("START = 2.0\nself.declare_parameter('speed', START)\nself.declare_parameter('name', input())\n")
    monkeypatch.setattr('edulaunch.desk.view.defaults.source_files', lambda index, package, executable: [str(program)])
    nodes, processes = [['/drive', 'drive-1']], [{'name': 'drive-1', 'package': 'mine', 'executable': 'drive'}]
    assert defaults_of(nodes, processes, [[0, '/drive', 'speed', 3.0, 'my.launch.py']], Index((), ())) == [
        ['/drive', 'speed', 2.0]
    ]
    assert defaults_of(nodes, processes, [[0, '/drive', 'speed', 2.0, 'default']], Index((), ())) == []


def test_a_transform_has_the_line_of_its_publisher(tmp_path: Path) -> None:
    program = tmp_path / 'fixed.py'
    program.write_text(
        'import rclpy\nfrom tf2_ros import TransformBroadcaster\nfrom geometry_msgs.msg import TransformStamped\n\n'
        "rclpy.init()\nnode = rclpy.create_node('fixed')\nsender = TransformBroadcaster(node)\n"
        "t = TransformStamped()\nt.header.frame_id, t.child_frame_id = 'world', 'arm'\nsender.sendTransform(t)\n"
    )
    file = tmp_path / 'my.launch.py'
    file.write_text(
        'from launch import LaunchDescription\nfrom launch.actions import ExecuteProcess\n\ndef generate_launch_description():\n'
        f"    return LaunchDescription([ExecuteProcess(cmd=['python3', {str(program)!r}])])\n"
    )
    delta = timeline_of(edulaunch.run(file, duration_s=1))
    (track,) = delta['tf']
    assert dict(delta['places'])[track['by']] == 'fixed.py:7'
    assert [row[7] for row in delta['processes'] if 'python3' in row[1]] == ['my.launch.py:5']
    assert RecordingSource(edulaunch.run(file, duration_s=1)).lines()
