"""A workspace's own message types, straight from source."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import edulaunch

TALKER = """
import rclpy
from rclpy.node import Node
from robo_msgs.msg import Part, Parts
import robo_msgs.srv as services


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.publisher = self.create_publisher(Parts, 'parts', 10)
        self.create_service(services.Count, 'count', self.count)
        self.client = self.create_client(services.Count, 'count')
        self.create_timer(1.0, self.tick)
        self.parts = Parts()

    def tick(self):
        self.parts.parts.append(Part(name=f'part{len(self.parts.parts)}'))
        self.publisher.publish(self.parts)
        self.client.call_async(services.Count.Request(parts=self.parts.parts)).add_done_callback(
            lambda future: self.get_logger().info(f'{future.result()}'))

    def count(self, request, response):
        response.number = len(request.parts)
        return response


def main():
    rclpy.init()
    rclpy.spin(Talker())
"""


@pytest.fixture
def robo(workspace: Any, launch_text: Callable[..., str]) -> Any:
    workspace.interfaces(
        'robo_msgs',
        msg_Part='string name\nfloat32 mass 1.5\n',
        msg_Parts='Part[] parts\ngeometry_msgs/Point place\n',
        srv_Count='robo_msgs/Part[] parts\n---\nint64 number\n',
    )
    workspace.python('robo', 'talker = robo.talker:main')
    workspace.write('robo/robo/talker.py', TALKER)
    workspace.write('go.launch.py', launch_text(('robo', 'talker')))
    return workspace


def run(workspace: Any, seconds: float = 2.5) -> edulaunch.Recording:
    return edulaunch.run(workspace.folder / 'go.launch.py', workspaces=[workspace.folder], duration_s=seconds)


def test_types_of_the_workspace_are_published_and_served(robo: Any) -> None:
    recording = run(robo)
    assert [(time, [part.name for part in message.parts]) for time, message in recording.messages('/parts')] == [
        (1.0, ['part0']),
        (2.0, ['part0', 'part1']),
    ]
    assert [log.message for log in recording.logs if log.logger == 'talker'] == [
        'robo_msgs.srv.Count_Response(number=1)',
        'robo_msgs.srv.Count_Response(number=2)',
    ]


@pytest.mark.processes
def test_a_recording_brings_the_types_that_it_needs(robo: Any, tmp_path: Path) -> None:
    recording = run(robo)
    recording.save(tmp_path / 'x.rec')
    code = (
        f'import edulaunch\nrecording = edulaunch.Recording.load({str(tmp_path / "x.rec")!r})\n'
        'print(recording.digest(), recording.messages("/parts")[0], recording.service_calls[1].response.number)'
    )
    read = subprocess.run([sys.executable, '-c', code], capture_output=True, text=True, check=True).stdout
    assert read == (
        f"{recording.digest()} (1.0, robo_msgs.msg.Parts(parts=[robo_msgs.msg.Part(name='part0', mass=1.5)], "
        'place=geometry_msgs.msg.Point(x=0.0, y=0.0, z=0.0))) 2\n'
    )


def test_two_workspaces_do_not_see_each_others_types(robo: Any, another_workspace: Any, launch_text: Callable[..., str]) -> None:
    another_workspace.interfaces('robo_msgs', msg_Part='int64 number\n')
    another_workspace.python('robo', 'talker = robo.talker:main')
    another_workspace.write('robo/robo/talker.py', 'from robo_msgs.msg import Part\ndef main():\n    print(Part(), flush=True)\n')
    another_workspace.write('go.launch.py', launch_text(('robo', 'talker')))
    first = run(robo)
    second = run(another_workspace)
    assert first.messages('/parts')[0][1].parts[0].mass == 1.5
    assert 'robo_msgs.msg.Part(number=0)\n' in [output.text for output in second.output]
    with pytest.raises(ImportError):
        __import__('robo_msgs.msg')


def test_a_type_that_is_not_there_is_an_import_error_with_the_nearest_name(robo: Any) -> None:
    robo.write('robo/robo/talker.py', 'from robo_msgs.msg import Prat\n')
    recording = run(robo)
    text = ''.join(row.text for row in recording.output)
    assert "ImportError: cannot import name 'Prat' from 'robo_msgs.msg'" in text and 'write Part' in recording.warnings[0]


def test_a_package_may_have_modules_and_interfaces(workspace: Any, launch_text: Callable[..., str]) -> None:
    workspace.write('mixed/msg/Num.msg', 'int64 num\n')
    workspace.write('mixed/mixed/__init__.py')
    workspace.write('mixed/mixed/numbers.py', 'from mixed.msg import Num\nONE = Num(num=1)\n')
    workspace.write('mixed/scripts/show.py', '#!/usr/bin/env python3\nfrom mixed.numbers import ONE\nprint(ONE)\n').chmod(0o755)
    workspace.cmake(
        'mixed',
        'rosidl_generate_interfaces(${PROJECT_NAME} "msg/Num.msg")\nament_python_install_package(mixed)\n'
        'install(PROGRAMS scripts/show.py DESTINATION lib/${PROJECT_NAME})\n',
    )
    workspace.write('go.launch.py', launch_text(('mixed', 'show.py')))
    assert 'mixed.msg.Num(num=1)\n' in [output.text for output in run(workspace).output]


def test_commands_know_the_types_of_the_workspace(robo: Any) -> None:
    robo.write(
        'go.launch.py',
        """
        from launch import LaunchDescription
        from launch.actions import ExecuteProcess
        def generate_launch_description():
            return LaunchDescription([ExecuteProcess(cmd=['ros2', 'interface', 'show', 'robo_msgs/msg/Part'])])
        """,
    )
    assert ''.join(row.text for row in run(robo).output if row.process == 'ros2-1') == 'string name\nfloat32 mass 1.5\n'


def test_underlay_packages_keep_their_types_when_a_copy_is_in_the_workspace(
    workspace: Any, launch_text: Callable[..., str]
) -> None:
    workspace.interfaces('turtlesim', msg_Color='uint8 r\nuint8 g\nuint8 b\n')
    workspace.python('robo', 'watch = robo.watch:main')
    workspace.write('robo/robo/watch.py', 'from turtlesim.msg import Color, Pose\ndef main():\n    print(Pose().theta)\n')
    workspace.write('go.launch.py', launch_text(('robo', 'watch')))
    assert '0.0\n' in [row.text for row in run(workspace).output]
