"""Programs that launch starts outside of the simulation end silently, unless launch's own lines are read."""

from __future__ import annotations

from pathlib import Path

import pytest

import edulaunch

LAUNCH = """from launch import LaunchDescription
from launch.actions import ExecuteProcess


def generate_launch_description():
    return LaunchDescription([ExecuteProcess(cmd=['python3', 'misspelt.py'])])
"""


@pytest.mark.processes
def test_a_script_that_is_not_there_is_told_with_what_python_said(tmp_path: Path) -> None:
    (tmp_path / 'main.launch.py').write_text(LAUNCH)
    warning = edulaunch.run(tmp_path / 'main.launch.py', duration_s=100.0).warnings[0]
    assert warning.startswith('python3-1 died with exit code 2') and "can't open file" in warning


def test_the_line_that_says_most_is_told_of_a_program_that_aborts(tmp_path: Path) -> None:
    (tmp_path / 'main.launch.py').write_text(
        LAUNCH.replace('launch.actions import ExecuteProcess', 'launch_ros.actions import Node').replace(
            "ExecuteProcess(cmd=['python3', 'misspelt.py'])",
            "Node(package='robot_state_publisher', executable='robot_state_publisher',"
            ' parameters=[{\'robot_description\': \'<robot name="r"><link name="a"/><link name="b"/></robot>\'}])',
        )
    )
    assert 'Two root links found' in edulaunch.run(tmp_path / 'main.launch.py', duration_s=1.0).warnings[0]
