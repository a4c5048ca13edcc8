"""Mistakes in a package as a student builds it: entry points, installed files, and lines that Python accepts.

Each case is a change of one healthy package. The examples of the rules start scripts, so they do not show how rules work with the
programs of a package, or with the links to its installed files.
"""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import edulaunch
from edulaunch.errors import LaunchFileError

HEAD = 'import rclpy\nfrom rclpy.node import Node\n'
MAIN = "\n\ndef main():\n    rclpy.init()\n    node = Own()\n    rclpy.spin(node)\n\n\nif __name__ == '__main__':\n    main()\n"
TALKER = f"""{HEAD}from std_msgs.msg import String


class Own(Node):
    def __init__(self):
        super().__init__('talker')
        self.pub = self.create_publisher(String, 'chatter', 10)
        self.declare_parameter('period', 0.5)
        self.timer = self.create_timer(self.get_parameter('period').value, self.tick)

    def tick(self):
        self.pub.publish(String(data='hello'))
{MAIN}"""
LISTENER = f"""{HEAD}from std_msgs.msg import Float64, String


class Own(Node):
    def __init__(self):
        super().__init__('listener')
        self.declare_parameter('gain', 1.0)
        self.sub = self.create_subscription(String, 'chatter', self.heard, 10)

    def heard(self, msg):
        number = Float64()
        number.data = self.get_parameter('gain').value
        self.get_logger().info(f'{{msg.data}} {{number.data}}')
{MAIN}"""
SETUP = """import os
from glob import glob

from setuptools import find_packages, setup

package_name = 'robo'
setup(
    name=package_name,
    version='0.0.0',
    packages=find_packages(exclude=['test']),
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
        (os.path.join('share', package_name, 'launch'), glob('launch/*')),
        (os.path.join('share', package_name, 'config'), glob('config/*')),
    ],
    install_requires=['setuptools'],
    entry_points={'console_scripts': ['talker = robo.talker:main', 'listener = robo.listener:main']},
)
"""
MANIFEST = """<package format="3">
  <name>robo</name><version>0.0.0</version><description>robo</description>
  <maintainer email="me@example.com">me</maintainer><license>Apache-2.0</license>
  <exec_depend>rclpy</exec_depend><exec_depend>std_msgs</exec_depend>
  <export><build_type>ament_python</build_type></export>
</package>
"""
LAUNCH = """import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch_ros.actions import Node


def generate_launch_description():
    share = get_package_share_directory('robo')
    return LaunchDescription([
        Node(package='robo', executable='talker', parameters=[os.path.join(share, 'config', 'talker.yaml')]),
        IncludeLaunchDescription(PythonLaunchDescriptionSource(os.path.join(share, 'launch', 'other.launch.py'))),
    ])
"""
OTHER = """from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([Node(package='robo', executable='listener')])
"""
FILES = {
    'package.xml': MANIFEST,
    'setup.py': SETUP,
    'setup.cfg': '[develop]\nscript_dir=$base/lib/robo\n[install]\ninstall_scripts=$base/lib/robo\n',
    'resource/robo': '',
    'robo/__init__.py': '',
    'robo/talker.py': TALKER,
    'robo/listener.py': LISTENER,
    'launch/main.launch.py': LAUNCH,
    'launch/other.launch.py': OTHER,
    'config/talker.yaml': 'talker:\n  ros__parameters:\n    period: 0.25\n',
}
CASES = {
    'spin_once': (
        'robo/listener.py',
        'rclpy.spin(node)',
        'rclpy.spin_once(node)',
        r'spin_once\(\).*src/robo/robo/listener.py:21',
    ),
    'loop_in_constructor': (
        'robo/listener.py',
        'self.heard, 10)\n',
        'self.heard, 10)\n        while rclpy.ok():\n            __import__("time").sleep(0.5)\n',
        r'never spins.*src/robo/robo/listener.py:12',
    ),
    'callback_in_quotes': ('robo/listener.py', 'self.heard, 10', "'heard', 10", r"string 'heard'.*\n.*self\.heard"),
    'parameter_object': ('robo/listener.py', "('gain').value", "('gain')", r'Parameter object.*listener.py:14.*\n.*\.value'),
    'key_of_parameter_file': ('config/talker.yaml', 'period', 'perriod', r"'perriod'.*src/robo/config/talker.yaml:3"),
    'config_not_installed': (
        'setup.py',
        "        (os.path.join('share', package_name, 'config'), glob('config/*')),\n",
        '',
        r"does not install .*src/robo/config/talker.yaml.*src/robo/launch/main.launch.py:13.*\n.*'config'\), glob\('config/\*'\)",
    ),
    'no_launch_folder': ('launch/main.launch.py', "'launch', 'other", "'other", r'write the path launch/other.launch.py'),
    'ending_of_executable': (
        'launch/other.launch.py',
        "'listener'",
        "'listener.py'",
        r"no executable named 'listener.py'; write 'listener'",
    ),
    'other_package': (
        'launch/other.launch.py',
        "package='robo'",
        "package='turtlesim'",
        r"no executable named 'listener'; .*package robo",
    ),
    'method_as_entry_point': ('setup.py', 'robo.talker:main', 'robo.talker:Own.main', r'function Own.main, .*\n.*write main'),
    'no_init_file': ('robo/__init__.py', None, None, r'no file __init__.py.*\n.*create the empty file robo/__init__.py'),
}


def write(folder: Path, change: tuple[str, str | None, str | None, str] | None) -> Path:
    """Write the package with one change, and return its launch file."""
    files: dict[str, str] = dict(FILES)
    if change is not None and change[1] is None:
        del files[change[0]]
    elif change is not None and change[1] is not None:
        assert change[1] in files[change[0]]
        files[change[0]] = files[change[0]].replace(change[1], change[2] or '')
    for name, text in files.items():
        path = folder / 'src' / 'robo' / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding='utf-8')
    return folder / 'src' / 'robo' / 'launch' / 'main.launch.py'


def reports(folder: Path, change: tuple[str, str | None, str | None, str] | None) -> tuple[list[str], str]:
    """Return what a run of the installed launch file reports, and its console."""
    write(folder, change)
    console: list[str] = []
    try:
        recording = edulaunch.run(
            'robo', 'main.launch.py', duration_s=6.0, workspaces=[folder], console=lambda *words: console.append(words[-1])
        )
    except LaunchFileError as error:
        return [str(error)], ''.join(console)
    return recording.warnings, ''.join(console)


@pytest.mark.parametrize('name', CASES)
def test_the_first_report_names_the_mistake_and_the_students_file(name: str, tmp_path: Path) -> None:
    found, console = reports(tmp_path, CASES[name])
    said = found[0] if found else console
    assert re.search(CASES[name][3], said), (found, console)
    assert not re.search(r'/edulaunch-\d+/ws-\S*\.py:\d', said)


def test_the_healthy_package_has_no_report(tmp_path: Path) -> None:
    assert reports(tmp_path, None)[0] == []


def test_a_folder_that_does_not_exist_is_an_error_of_the_start(tmp_path: Path) -> None:
    found, console = reports(tmp_path, ('launch/other.launch.py', "'listener'", "'listener', cwd='/no/folder'", ''))
    assert "FileNotFoundError: [Errno 2] No such file or directory: '/no/folder'" in console
    assert "cwd='/no/folder' does not exist; create it" in console
    assert found == []


def test_a_typed_launch_names_its_files_although_it_starts_no_program(tmp_path: Path) -> None:
    from edulaunch.engine.processes.spec import ProcessSpec
    from edulaunch.runtime.session import Session

    file = tmp_path / 'who.launch.py'
    file.write_text(
        'from launch import LaunchDescription\n'
        'from launch.actions import DeclareLaunchArgument\n'
        'from launch.conditions import LaunchConfigurationEquals\n'
        'from launch_ros.actions import Node\n\n\n'
        'def generate_launch_description():\n'
        "    wanted = LaunchConfigurationEquals('talker', 'who')\n"
        "    node = Node(package='demo_nodes_py', executable='talker', condition=wanted)\n"
        "    return LaunchDescription([DeclareLaunchArgument('who', default_value='talker'), node])\n",
        encoding='utf-8',
    )
    with Session() as session:
        process = session.host.start(ProcessSpec(argv=('ros2', 'launch', str(file)), name='ros2'))
        session.run(2.0)
        found = session.of_command(process.pid).advice
    assert [(one.rule, one.file, one.line) for one in found[:1]] == [('launch.equals-swapped', str(file), 8)]


def test_values_that_the_shell_split_get_quotes(capsys: pytest.CaptureFixture[str]) -> None:
    from edulaunch.desk.cli.ros2.commands import command_line

    with pytest.raises(SystemExit):
        command_line(['service', 'call', '/spawn', 'turtlesim/srv/Spawn', '{x:', '2,', 'y:', '2}'])
    assert 'help: put the values into double quotes' in capsys.readouterr().err


def test_a_launch_file_without_its_package_gets_the_name_of_the_package(tmp_path: Path) -> None:
    from edulaunch.errors import UnusableInput
    from edulaunch.runtime.launching import find_launch_file
    from edulaunch.runtime.session import Session

    write(tmp_path, None)
    with Session(workspaces=[tmp_path]) as session, pytest.raises(UnusableInput) as raised:
        find_launch_file(session.index, str(tmp_path / 'other.launch.py'), None)
    assert raised.value.help == 'name its package, too: ros2 launch robo other.launch.py'
