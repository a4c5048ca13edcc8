"""Terminals in a workspace: what is written there is found, in the state in which it is."""

from __future__ import annotations

import json
import socket
from pathlib import Path

import pytest

from edulaunch.desk.machine import wire
from edulaunch.desk.machine.client import hello
from edulaunch.desk.machine.place import read_address
from edulaunch.runtime.framing import Frames, frame
from tests.desk.machine.shells import PATIENCE_S, Desk
from tests.desk.machine.workspace import make_package

SAYS = """import rclpy
from mine_msgs.msg import Place
from rclpy.node import Node


def main():
    rclpy.init()
    node = Node('says')
    publisher = node.create_publisher(Place, 'places', 10)
    node.get_logger().info('there is a publisher')
    node.create_timer(0.1, lambda: publisher.publish(Place(x=1.5)))
    rclpy.spin(node)
"""
CMAKE = """cmake_minimum_required(VERSION 3.8)
project(mine_msgs)
find_package(rosidl_default_generators REQUIRED)
rosidl_generate_interfaces(${PROJECT_NAME} "msg/Place.msg")
ament_package()
"""
MANIFEST = (
    '<package format="3"><name>mine_msgs</name><version>0.0.1</version><buildtool_depend>ament_cmake</buildtool_depend>'
    '<member_of_group>rosidl_interface_packages</member_of_group><export><build_type>ament_cmake</build_type></export></package>'
)


def make_messages(desk: Desk, text: str) -> None:
    place = desk.folder / 'src' / 'mine_msgs'
    (place / 'msg').mkdir(parents=True, exist_ok=True)
    for name, content in {'CMakeLists.txt': CMAKE, 'package.xml': MANIFEST, 'msg/Place.msg': text}.items():
        (place / name).write_text(content)


def test_terminals_talk_in_types_of_the_workspace(desk: Desk) -> None:
    make_messages(desk, 'float64 x\n')
    make_package(desk.folder, {'says': SAYS})
    says = desk.ros2('run mine says')
    says.until('there is a publisher')
    assert desk.said('topic echo --once /places') == 'x: 1.5\n---\n'
    assert desk.said('topic list -t').splitlines()[1] == '/places [mine_msgs/msg/Place]'
    assert not says.gone()


def test_a_program_that_was_edited_is_read_anew(desk: Desk) -> None:
    make_package(desk.folder, {'one': "def main():\n    print('first')\n"})
    assert desk.said('run mine one') == 'first\n'
    make_package(desk.folder, {'one': "def main():\n    print('second one')\n", 'two': "def main():\n    print('another')\n"})
    assert desk.said('run mine one') == 'second one\n'
    assert desk.said('run mine two') == 'another\n'
    assert desk.said('pkg executables mine') == 'mine one\nmine two\n'


def test_a_package_that_is_not_there_is_looked_for_below_the_folder_of_the_terminal(desk: Desk) -> None:
    make_package(desk.folder / 'one' / 'level' / 'deeper', {})
    told = desk.said('run mine anything')
    assert told.startswith("Package 'mine' not found\n") and 'one/level/deeper' in told


def test_of_two_packages_with_one_name_the_nearest_to_the_terminal_is_used_and_named(desk: Desk) -> None:
    for week in ('week2', 'week3'):
        make_package(desk.folder / 'src' / week, {'says': f"def main():\n    print('{week}')\n"})
        (desk.folder / 'src' / week / 'src' / 'mine').rename(desk.folder / 'src' / week / 'mine')
    desk.folder = desk.folder / 'src' / 'week3'
    assert (
        desk.said('run mine says')
        == 'note: several packages have the name mine; this command uses mine, not ../week2/mine\nweek3\n'
    )


def test_a_terminal_of_the_page_finds_the_packages_and_files_of_the_terminal_that_opened_the_page(
    desk: Desk, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    desk.ros2('run demo_nodes_py talker').until('Publishing')  # the machine began in another folder
    student = tmp_path / 'student'
    make_package(student, {'one': "def main():\n    print('from the workspace')\n"})
    (student / 'own.launch.xml').write_text('<launch><log message="from the folder"/></launch>')
    monkeypatch.chdir(student)
    address = read_address(str(desk.place), '0')
    assert address is not None
    with socket.socket(socket.AF_UNIX) as page:
        page.settimeout(PATIENCE_S)
        page.connect(address.place)
        page.sendall(hello(address.token, ['machine', 'view'], keyboard=False))
        for number, line in enumerate(('ros2 run mine one', 'ros2 launch own.launch.xml')):
            request = json.dumps({'op': 'line', 'line': line, 'pane': number})
            page.sendall(frame(wire.INPUT, f'{request}\n'.encode()))
        page.sendall(frame(wire.INPUT, b'{"op": "complete", "line": "ros2 run mi"}\n'))
        frames, said = Frames(wire.FROM_MACHINE), ''
        while not all(text in said for text in ('from the workspace', 'from the folder', 'ros2 run mine ')):
            said += ''.join(payload.decode() for kind, payload in frames.feed(page.recv(1 << 16)) if kind == wire.OUTPUT)
            assert 'not found' not in said and 'malformed' not in said
