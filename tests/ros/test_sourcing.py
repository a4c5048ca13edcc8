"""What counts as an overlay."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from edulaunch import Session
from edulaunch.engine.packages.discovery import install_folders


@pytest.mark.parametrize(
    ('sign', 'is_built'),
    [
        ('.colcon_install_layout', True),
        ('local_setup.bash', True),
        ('share/ament_index/x', True),
        ('src/robo/package.xml', False),
    ],
)
def test_folders_that_colcon_installed_into_are_told_from_sources(tmp_path: Path, sign: str, is_built: bool) -> None:
    (tmp_path / sign).parent.mkdir(parents=True, exist_ok=True)
    (tmp_path / sign).write_text('')
    assert install_folders([tmp_path]) == (([str(tmp_path)], []) if is_built else ([], [str(tmp_path)]))


def test_a_session_watches_its_programs_unless_told_not_to() -> None:
    with Session() as session, Session(turn_limit_s=0) as unwatched:
        assert session.host.watchdog is not None and session.host.watchdog.seconds == 2.0
        assert unwatched.host.watchdog is None


@pytest.mark.processes
def test_sourcing_a_workspace_makes_its_modules_interfaces_and_programs_available(tmp_path: Path) -> None:
    texts = {
        'robo/package.xml': '<package format="3"><name>robo</name></package>',
        'robo/setup.cfg': '[install]\ninstall_scripts=$base/lib/robo\n',
        'robo/setup.py': "from setuptools import setup\nsetup(packages=['robo'], data_files=[('share/ament_index/resource_index/"
        "packages', ['resource/robo'])], entry_points={'console_scripts': ['go = robo.parts:main']})\n",
        'robo/resource/robo': '',
        'robo/robo/__init__.py': '',
        'robo/robo/parts.py': "def main():\n    print('went')\n",
        'robo_msgs/package.xml': '<package format="3"><name>robo_msgs</name></package>',
        'robo_msgs/CMakeLists.txt': 'project(robo_msgs)\nrosidl_generate_interfaces(robo_msgs msg/Part.msg)\n',
        'robo_msgs/msg/Part.msg': 'string name\n',
    }
    for name, text in texts.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    script = f"""
import edulaunch
edulaunch.source(workspaces=[{str(tmp_path)!r}])
from robo.parts import main
from robo_msgs.msg import Part
from rosidl_runtime_py.utilities import get_message
print(get_message('robo_msgs/msg/Part') is Part)
from ament_index_python.packages import get_package_prefix
from launch import LaunchDescription, LaunchService
from launch_ros.actions import Node
print(Part(name='arm').name, get_package_prefix('robo') != '')
service = LaunchService(noninteractive=True)
service.include_launch_description(LaunchDescription([Node(package='robo', executable='go', output='screen')]))
print(service.run())
edulaunch.source(workspaces=[{str(tmp_path)!r}])
"""
    done = subprocess.run([sys.executable, '-c', script], cwd='/', capture_output=True, text=True, timeout=60, check=False)
    assert done.stdout.startswith('True\narm True\n') and '[go-1] went' in done.stdout + done.stderr, done.stderr
