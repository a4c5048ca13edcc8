"""A machine with a turtlesim for lines of `ros2`; launch files of a few entities, launched as on the command line."""

from __future__ import annotations

import shlex
import signal
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from edulaunch.desk.cli.main import main
from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.runtime.session import Session

HEAD = 'from launch import LaunchDescription\nfrom launch.actions import *\nfrom launch_ros.actions import Node\n'


class Typed:
    """One command that was typed: what it wrote, when, and how it ended."""

    def __init__(self, machine: Machine, line: str, cwd: Path) -> None:
        self._machine = machine
        self.writes: list[tuple[float, str]] = []
        self.out = self.err = ''
        self.code: int | None = None
        spec = ProcessSpec(argv=tuple(shlex.split(line)), name=f'typed-{line}', cwd=str(cwd))
        self.process: Any = machine.session.host.start(spec, self._on_output, self._on_exit)

    def _on_output(self, stream: str, text: str) -> None:
        self.writes.append((self._machine.now(), text))
        if stream == 'stdout':
            self.out += text
        else:
            self.err += text

    def _on_exit(self, code: int) -> None:
        self.code = code

    def interrupt(self) -> None:
        """Ctrl-C, and a little time to end."""
        self.process.send_signal(signal.SIGINT)
        self._machine.session.run(2.0)


class Machine:
    """Types commands; `turtlesim` runs as node /sim since the beginning, and a second has passed."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.session = Session()
        self.turtlesim = self.start('ros2 run turtlesim turtlesim_node --ros-args -r __node:=sim')
        self.session.run(1.0)

    def now(self) -> float:
        """Simulated seconds since the machine was switched on."""
        return (self.session.sim.now_ns - self.session.sim.start_ns) / 1e9

    def start(self, line: str) -> Typed:
        """Type a command and let it begin."""
        return Typed(self, line, self.folder)

    def run(self, line: str, seconds: float = 0.2) -> Typed:
        """Type a command and let it run for some simulated seconds."""
        typed = self.start(line)
        self.session.run(seconds)
        return typed

    def read(self, line: str) -> str:
        """What a command that succeeds writes."""
        typed = self.run(line)
        assert (typed.code, typed.err) == (0, '')
        return typed.out

    def fails(self, line: str, seconds: float = 0.2) -> str:
        """What a command that fails with status 1 complains of."""
        typed = self.run(line, seconds)
        assert (typed.code, typed.out) == (1, '')
        return typed.err


@pytest.fixture
def machine(tmp_path: Path) -> Iterator[Machine]:
    machine = Machine(tmp_path)
    yield machine
    machine.session.close()


def describe(*entities: str) -> str:
    return f'{HEAD}def generate_launch_description():\n    return LaunchDescription([{", ".join(entities)}])\n'


@pytest.fixture
def run(tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    """Write a launch file, run it as the command does, and return (exit code, stdout, stderr) without the folder's path."""

    def run_command(text: str | bytes, *words: str, name: str = 'my.launch.py') -> tuple[int, str, str]:
        path = tmp_path / name
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        code = main(['launch', str(path), '--fast', '--for', '3', *words])
        out, err = capsys.readouterr()
        return code, out.replace(str(tmp_path), '@'), err.replace(str(tmp_path), '@')

    return run_command
