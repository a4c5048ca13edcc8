"""The command `edulaunch` as a shell starts it."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from edulaunch.engine.recording import Recording

LAUNCH = """from launch import LaunchDescription
from launch.actions import ExecuteProcess
def generate_launch_description():
    return LaunchDescription([ExecuteProcess(cmd=['python3', 'sets.py'], output='screen')])
"""
SETS = """print({'ada', 'grace', 'hedy', 'joan', 'katherine'}, hash('radia'))
"""


@pytest.mark.processes
@pytest.mark.skipif(sys.platform == 'win32', reason='Python is not started again there')
def test_sets_of_strings_have_one_order_in_every_launch(tmp_path: Path) -> None:
    (tmp_path / 'one.launch.py').write_text(LAUNCH)
    (tmp_path / 'sets.py').write_text(SETS)
    env = {**os.environ, 'PYTHONPATH': os.pathsep.join(sys.path)}
    env.pop('PYTHONHASHSEED', None)
    digests = set()
    for name in ('first', 'second', 'third'):
        words = ['launch', 'one.launch.py', '--fast', '--for', '1', '--record', name]
        subprocess.run([sys.executable, '-m', 'edulaunch', *words], cwd=tmp_path, env=env, check=True, capture_output=True)
        digests.add(Recording.load(tmp_path / name).digest())
    assert len(digests) == 1
