"""Which part of a machine's recording belongs to one command."""

from __future__ import annotations

from pathlib import Path

import pytest

from edulaunch.engine.recording import Recording
from edulaunch.runtime.session import Session

LAUNCH = """from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([Node(package='demo_nodes_py', executable='{executable}', name='{name}')])
"""


def _file(folder: Path, executable: str, name: str) -> Path:
    file = folder / f'{name}.launch.py'
    file.write_text(LAUNCH.format(executable=executable, name=name))
    return file


def _nodes(recording: Recording) -> list[tuple[str, str]]:
    return [(node.name, node.process) for node in recording.nodes if '/launch_ros' not in node.name]


def test_what_ran_before_is_left_out_and_what_runs_beside_is_renamed(tmp_path: Path) -> None:
    with Session() as session:
        before = session.launch(_file(tmp_path, 'talker', 'before'))
        session.run(2.0)
        before.interrupt()
        session.run(2.0)
        beside = session.launch(_file(tmp_path, 'talker', 'beside'))
        session.run(1.5)
        own = session.launch(_file(tmp_path, 'listener', 'own'))
        session.run(2.5)
        recording = session.of_command(own.process.pid)
        talker = next(process.pid for process in recording.processes if process.argv[0].endswith('talker'))
        assert _nodes(recording) == [('/beside', 'talker-1'), ('/own', 'listener-1')]
        assert recording.command == {'launch', 'listener-1'}
        assert recording.beside[f'launch (pid {beside.process.pid})'].endswith('beside.launch.py')
        assert [round(time, 3) for time, _ in recording.messages('/chatter')] == [6.0, 7.0, 8.0]
        assert {row.process for row in recording.logs} >= {'talker-1', 'listener-1'}
        assert recording.launch.file.endswith('own.launch.py') and recording.duration_s == 8.0
        again = session.of_command(before.process.pid)
        assert _nodes(again) == [('/before', 'talker-1')] and again.duration_s == 2.0
        assert talker != next(process.pid for process in again.processes if process.argv[0].endswith('talker'))
        with pytest.raises(KeyError):
            session.of_command(1)


def test_a_program_of_the_same_name_beside_it_gets_its_process_id(tmp_path: Path) -> None:
    file = _file(tmp_path, 'talker', 'talker')
    with Session() as session:
        session.launch(file)
        session.run(1.0)
        second = session.launch(file)
        session.run(1.0)
        recording = session.of_command(second.process.pid)
        (first, own) = _nodes(recording)
        assert own == ('/talker', 'talker-1') and first[1].startswith('talker-1 (pid ')
        assert recording.command == {'launch', 'talker-1'}


def test_a_latched_message_from_before_counts(tmp_path: Path) -> None:
    with Session() as session:
        broadcaster = tmp_path / 'static.launch.py'
        broadcaster.write_text(
            LAUNCH.format(executable='static_transform_publisher', name='static')
            .replace('demo_nodes_py', 'tf2_ros')
            .replace("name='static'", "arguments=['--frame-id', 'map', '--child-frame-id', 'arm']")
        )
        session.launch(broadcaster)
        session.run(2.0)
        own = session.launch(_file(tmp_path, 'talker', 'own'))
        session.run(1.0)
        recording = session.of_command(own.process.pid)
        assert len(recording.messages('/tf_static')) == 1


def test_a_finding_names_the_line_that_makes_the_end(tmp_path: Path) -> None:
    file = tmp_path / 'driver.py'
    file.write_text(
        'import rclpy\nfrom geometry_msgs.msg import Twist\nfrom rclpy.node import Node\n\n'
        "rclpy.init()\nnode = Node('driver')\npublisher = node.create_publisher(Twist, 'cmd_val', 10)\n"
        'node.create_timer(0.1, lambda: publisher.publish(Twist()))\nrclpy.spin(node)\n'
    )
    launch = tmp_path / 'main.launch.py'
    launch.write_text(
        'from launch import LaunchDescription\nfrom launch.actions import ExecuteProcess\n\n\ndef generate_launch_description():\n'
        f"    return LaunchDescription([ExecuteProcess(cmd=['python3', {str(file)!r}])])\n"
    )
    with Session() as session:
        own = session.launch(launch)
        session.run(2.0)
        assert session.recorder.lines and {place[0] for place in session.recorder.lines.values()} == {str(file)}
        for recording in (session.of_command(own.process.pid), session.snapshot(), session.recording()):
            (finding,) = recording.advice
            assert (finding.rule, finding.file, finding.line) == ('messages.nobody-listens', str(file), 7)
