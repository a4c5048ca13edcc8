"""AMENT_PREFIX_PATH inside of a launch names what was sourced: the workspaces of the session, then ROS 2 itself."""

from __future__ import annotations

from pathlib import Path

import edulaunch
from edulaunch.engine.underlay_place import underlay_prefix

LAUNCH = """from launch import LaunchDescription
from launch.actions import ExecuteProcess, LogInfo
from launch.substitutions import EnvironmentVariable
def generate_launch_description():
    return LaunchDescription([
        LogInfo(msg=['path ', EnvironmentVariable('AMENT_PREFIX_PATH')]),
        ExecuteProcess(cmd=['python3', {script!r}], output='screen'),
    ])
"""
SCRIPT = """import os
from ament_index_python import get_package_prefix, get_search_paths
print('path', os.environ['AMENT_PREFIX_PATH'])
mine = get_package_prefix('mine')
os.environ['AMENT_PREFIX_PATH'] = '/nowhere:' + os.environ['AMENT_PREFIX_PATH']
print('found', get_package_prefix('mine') == mine, get_search_paths().count(mine))
os.environ['AMENT_PREFIX_PATH'] = os.environ['AMENT_PREFIX_PATH'].replace(mine, '/gone')
try:
    get_package_prefix('mine')
except LookupError:
    print('gone')
"""
MANIFEST = '<package format="3"><name>mine</name><version>0.0.1</version></package>'


def test_the_launch_file_and_its_programs_see_the_workspaces(tmp_path: Path) -> None:
    package = tmp_path / 'ws/src/mine'
    package.mkdir(parents=True)
    (package / 'package.xml').write_text(MANIFEST)
    (package / 'setup.py').write_text("from setuptools import setup\nsetup(name='mine', packages=[])\n")
    (tmp_path / 'script.py').write_text(SCRIPT)
    file = tmp_path / 'a.launch.py'
    file.write_text(LAUNCH.format(script=str(tmp_path / 'script.py')))
    recording = edulaunch.run(file, workspaces=[tmp_path / 'ws'], duration_s=1.0)
    paths = [row.text.partition('path ')[2].strip().split(':') for row in recording.output if 'path ' in row.text]
    assert len(paths) == 3 and paths[0] == paths[1] == paths[2]
    assert len(paths[0]) == 2 and paths[0][1] == underlay_prefix() and Path(paths[0][0]).name.startswith('ws-')
    said = [row.text for row in recording.output if row.process == 'python3-1'][1:]
    assert said == ['found True 1\n', 'gone\n']
