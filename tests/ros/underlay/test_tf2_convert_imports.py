"""What `import tf2_geometry_msgs` registers holds for the program that imports it, and for no other one."""

from __future__ import annotations

from pathlib import Path

import edulaunch

PROGRAM = """
{first}
import rclpy
from geometry_msgs.msg import PointStamped
from tf2_ros import TransformRegistration
try:
    print(TransformRegistration().get(PointStamped).__name__)
except Exception as error:
    print(type(error).__name__)
"""
LAUNCH = """
from launch import LaunchDescription
from launch.actions import ExecuteProcess, TimerAction
def generate_launch_description():
    first, second = (ExecuteProcess(cmd=['python3', name], cwd={folder!r}, output='screen') for name in ('one.py', 'two.py'))
    return LaunchDescription([first, TimerAction(period=1.0, actions=[second])])
"""


def test_a_program_has_the_conversions_that_it_imported_itself(tmp_path: Path) -> None:
    (tmp_path / 'one.py').write_text(PROGRAM.format(first='import tf2_geometry_msgs'))
    (tmp_path / 'two.py').write_text(PROGRAM.format(first=''))
    (tmp_path / 'two.launch.py').write_text(LAUNCH.format(folder=str(tmp_path)))
    recording = edulaunch.run(tmp_path / 'two.launch.py', duration_s=3, console=lambda *_: None)
    printed = [
        (line.process, line.text.strip()) for line in recording.output if line.stream == 'stdout' and line.process != 'launch'
    ]
    assert printed == [('python3-1', 'do_transform_point'), ('python3-2', 'TypeException')]
