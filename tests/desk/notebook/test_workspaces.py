"""Which packages the commands of a notebook find."""

from __future__ import annotations

from typing import Any

import pytest

from edulaunch.errors import UnusableInput

PACKAGE_XML = '<?xml version="1.0"?><package format="3"><name>mine</name><version>0.0.1</version></package>'


@pytest.fixture
def workspace(desk: Any) -> Any:
    desk.write('my_ws/src/mine/package.xml', PACKAGE_XML)
    return desk


def test_a_workspace_beside_the_notebook_is_found_by_itself(workspace: Any) -> None:
    assert workspace.terminal.workspaces() == [str(workspace.folder / 'my_ws')]


def test_a_notebook_inside_a_workspace_finds_it_too(desk: Any) -> None:
    desk.write('src/mine/package.xml', PACKAGE_XML)
    assert desk.terminal.workspaces() == [str(desk.folder)]


@pytest.mark.parametrize(
    'word', ['my_ws', 'my_ws/', 'my_ws/install', 'my_ws/install/setup.bash', 'my_ws/install/local_setup.bash']
)
def test_sourcing_takes_what_a_shell_takes_without_a_build(workspace: Any, word: str) -> None:
    workspace.terminal.source(word)
    assert workspace.terminal.workspaces() == [str(workspace.folder / 'my_ws')]


def test_an_install_folder_that_exists_is_used(workspace: Any) -> None:
    (workspace.folder / 'my_ws' / 'install').mkdir()
    workspace.terminal.source('my_ws/install/setup.bash')
    assert workspace.terminal.workspaces() == [str(workspace.folder / 'my_ws' / 'install')]


def test_a_folder_that_is_not_there_is_refused(desk: Any) -> None:
    with pytest.raises(UnusableInput, match="'my_wss': there is no such workspace"):
        desk.terminal.source('my_wss')


@pytest.mark.parametrize(
    ('line', 'part'),
    [
        ('colcon build --symlink-install', 'edulaunch needs no build'),
        ('colcon', 'edulaunch needs no build'),
        ('rosdep install -i --from-path src -y', 'you do not need to install anything'),
        ('apt install ros-jazzy-turtlesim', 'turtlesim is already part of edulaunch'),
    ],
)
def test_what_sets_up_a_real_machine_gets_one_sentence(desk: Any, line: str, part: str) -> None:
    desk.terminal.set_up(line)
    assert part in ''.join(desk.said) and ''.join(desk.said).count('\n') == 1


def test_sourcing_ros_itself_is_not_needed_and_another_command_is_none_of_ours(desk: Any) -> None:
    desk.terminal.source('/opt/ros/jazzy/setup.bash')
    assert 'you do not need to source ROS 2 Jazzy' in ''.join(desk.said)
    with pytest.raises(UnusableInput, match='is not a set-up command of ROS 2'):
        desk.terminal.set_up('apt install vim')


SETUP = """from setuptools import setup
setup(name='mine', packages=['mine'], entry_points={'console_scripts': ['hello = mine.hello:main']})
"""


def test_a_package_that_is_made_after_the_first_command_is_found(desk: Any) -> None:
    desk.ros2('topic list')
    desk.write('my_ws/src/mine/package.xml', PACKAGE_XML)
    desk.write('my_ws/src/mine/setup.py', SETUP)
    desk.write('my_ws/src/mine/setup.cfg', '[install]\ninstall_scripts=$base/lib/mine\n')
    desk.write('my_ws/src/mine/mine/__init__.py', '')
    desk.write('my_ws/src/mine/mine/hello.py', 'def main():\n    print("here I am")\n')
    desk.ros2('run mine hello')
    assert desk.said == ['here I am\n']
    desk.ros2('pkg executables mine')
    assert desk.said == ['mine hello\n']


def test_a_package_that_is_made_in_a_workspace_that_was_there_before_is_found(workspace: Any) -> None:
    workspace.ros2('topic list')
    workspace.write('my_ws/src/late/package.xml', PACKAGE_XML.replace('mine', 'late'))
    workspace.write('my_ws/src/late/setup.py', SETUP.replace('mine', 'late'))
    workspace.write('my_ws/src/late/setup.cfg', '[install]\ninstall_scripts=$base/lib/late\n')
    workspace.write('my_ws/src/late/late/__init__.py', '')
    workspace.write('my_ws/src/late/late/hello.py', 'def main():\n    print("here I am")\n')
    workspace.ros2('run late hello')
    assert workspace.said == ['here I am\n']
    workspace.write('my_ws/src/late/setup.py', SETUP.replace('mine', 'late').replace('hello =', 'again ='))
    workspace.ros2('run late again')
    assert workspace.said == ['here I am\n']


SPINS = """import rclpy
from rclpy.node import Node


def main():
    rclpy.init()
    rclpy.spin(Node('hello'))
"""


def test_a_program_that_is_stopped_has_not_died(workspace: Any) -> None:
    workspace.write('my_ws/src/mine/setup.py', SETUP)
    workspace.write('my_ws/src/mine/setup.cfg', '[install]\ninstall_scripts=$base/lib/mine\n')
    workspace.write('my_ws/src/mine/mine/__init__.py', '')
    workspace.write('my_ws/src/mine/mine/hello.py', SPINS)
    workspace.ros2('run mine hello --for 1')
    assert 'KeyboardInterrupt' in workspace.output and workspace.output.endswith('[ros2run]: Interrupt\n')
