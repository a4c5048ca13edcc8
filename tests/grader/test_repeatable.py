"""The same submission gets the same mark and the same report, byte for byte, in every process that grades it."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

HEAD = """import os, random, tempfile
from launch import LaunchDescription
from launch_ros.actions import Node
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
"""
SET_DECIDES = """
    radius = {'first': LaunchConfiguration('circle_radius'), 'second': 0.5, 'third': 0.7}
    chosen = next(iter({'first', 'second', 'third'}))
    return LaunchDescription([
        DeclareLaunchArgument('circle_radius', default_value='1.0'),
        IncludeLaunchDescription(PythonLaunchDescriptionSource(PathJoinSubstitution(
            [FindPackageShare('turtlebot3_gazebo'), 'launch', 'empty_world.launch.py']))),
        Node(package='part3_beyond_basics', executable='param_circle.py', parameters=[{'radius': radius[chosen]}]),
    ])
"""
SHOWS_ITS_PROCESS = """
    raise ValueError(object(), Node(package='a', executable='b'), tempfile.mktemp(), os.getcwd(), random.random(), hash('a'))
"""


def report(file: Path, hash_seed: str) -> tuple[bytes, bytes]:
    """What the command prints and writes, in a process of its own."""
    data = file.with_suffix('.json')
    command = [sys.executable, '-m', 'edugrade', str(file), '--json', str(data), '--html', str(file.with_suffix('.html'))]
    environment = {**os.environ, 'PYTHONHASHSEED': hash_seed, 'COLUMNS': '100'}
    printed = subprocess.run(command, env=environment, cwd=file.parent, capture_output=True).stdout
    return printed, data.read_bytes() + file.with_suffix('.html').read_bytes()


@pytest.mark.whole
@pytest.mark.parametrize('body', [SET_DECIDES, SHOWS_ITS_PROCESS], ids=['a set decides', 'it shows what differs'])
def test_two_processes_report_the_same_bytes(tmp_path: Path, body: str) -> None:
    file = tmp_path / 'circle.launch.py'
    file.write_text(HEAD + body)
    first, other = [report(file, seed) for seed in ('1', '2')]
    assert b'circle' in first[0]
    assert other == first
