"""Commands in a terminal whose locale cannot show every letter: they print what they can, and no traceback."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

LOCALES = (
    {'LC_ALL': 'C', 'PYTHONCOERCECLOCALE': '0', 'PYTHONUTF8': '0'},
    {'LC_ALL': 'POSIX', 'PYTHONIOENCODING': 'ascii'},
    {'LC_ALL': 'de_DE.ISO-8859-1', 'PYTHONIOENCODING': 'latin-1', 'LANGUAGE': 'de'},
)
LAUNCH = """from launch import LaunchDescription
from launch.actions import LogInfo
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([LogInfo(msg='Tür → 日本'), Node(package='turtlesim', executable='turtlesim_nod')])
"""
COMMANDS = {
    'ros2': ('edulaunch.desk.machine.command:ros2', ('launch', 'tür.launch.py')),
    'edulaunch launch': ('edulaunch.desk.cli.main:main', ('launch', 'tür.launch.py')),
    'edulaunch explain': ('edulaunch.desk.cli.main:main', ('explain', 'tür.launch.py')),
    'edulaunch doctor': ('edulaunch.desk.cli.main:main', ('doctor', 'tür.launch.py')),
    'edugrade': ('edugrade.cli:main', ('grade', 'kein', 'tür.launch.py')),
}


@pytest.mark.processes
@pytest.mark.parametrize('locale', LOCALES, ids=lambda locale: str(locale['LC_ALL']))
@pytest.mark.parametrize('command', COMMANDS)
def test_a_locale_without_utf_8_is_no_traceback(command: str, locale: dict[str, str], tmp_path: Path) -> None:
    (tmp_path / 'tür.launch.py').write_text(LAUNCH, encoding='utf-8')
    entry, words = COMMANDS[command]
    module, function = entry.split(':')
    program = f'import sys; from {module} import {function}; sys.exit({function}())'
    env = {name: value for name, value in os.environ.items() if not name.startswith(('LC_', 'LANG', 'PYTHON'))}
    env |= {'XDG_RUNTIME_DIR': str(tmp_path), 'EDULAUNCH_GRACE_S': '0.2', **locale}
    done = subprocess.run([sys.executable, '-c', program, *words], cwd=tmp_path, env=env, capture_output=True, timeout=100)
    output = (done.stdout + done.stderr).decode('utf-8', 'replace')
    assert done.returncode in (0, 1, 2) and output, output
    assert 'Traceback' not in output and 'codec' not in output, output
