"""A terminal on a simulated machine whose output is kept."""

from __future__ import annotations

from pathlib import Path

import pytest

from edulaunch.desk.notebook.terminal import CellTerminal
from edulaunch.engine.recording import Recording

LAUNCH = """from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node', name='sim', parameters=[{'background_r': 30}]),
    ])
"""


class Desk:
    """A folder with a launch file, and a terminal in it."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.said: list[str] = []
        self.terminal = CellTerminal(lambda stream, text: self.said.append(text))
        self.write('sim.launch.py', LAUNCH)

    def write(self, name: str, text: str) -> None:
        place = self.folder / name
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_text(text, encoding='utf-8')

    def ros2(self, line: str) -> Recording | None:
        """Run a command line; afterwards `output` holds what it printed."""
        self.said.clear()
        return self.terminal.ros2(line)

    @property
    def output(self) -> str:
        return ''.join(self.said)


@pytest.fixture
def desk(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Desk:
    """A desk in a folder of its own."""
    monkeypatch.chdir(tmp_path)
    return Desk(tmp_path)
