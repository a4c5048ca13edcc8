"""A small world in which single scripts run as processes."""

from __future__ import annotations

import textwrap
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from edulaunch.engine.graph.graph import Graph
from edulaunch.engine.packages import Program
from edulaunch.engine.processes.host import Host
from edulaunch.engine.processes.process import Process
from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.engine.sim.simulation import Simulation
from edulaunch.runtime.fittings import hint_of


class ScriptIndex:
    """Knows the scripts of one folder by their path."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def find_program(self, path: str) -> Program | None:
        if not path.startswith(str(self.folder)):
            return None
        return Program(
            kind='script',
            package='scripts',
            executable=Path(path).name,
            path=path,
            file=path,
            python_roots=(str(self.folder / 'lib'),),
        )

    def packages(self) -> dict[str, str]:
        return {}

    def python_modules(self) -> dict[str, str]:
        return {}

    def interface_roots(self) -> list[str]:
        return []


class World:
    """Writes scripts, runs them, and keeps an ordered log of (simulated seconds, program, what it wrote)."""

    def __init__(self, folder: Path, seed: int = 0) -> None:
        self.folder = folder
        self.sim = Simulation(seed)
        self.host = Host(
            self.sim,
            Graph(self.sim),
            ScriptIndex(folder),
            env={'HOME': '/home/student', 'USER': 'ada', 'LOGNAME': 'ada'},  # type: ignore[arg-type]
            hint_of=hint_of,
            stdin={'asks-1': 'first line\nsecond line\n'},
        )
        self.log: list[tuple[float, str, str]] = []
        self.codes: dict[str, int] = {}

    def write(self, name: str, text: str) -> str:
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(textwrap.dedent(text))
        return str(path)

    def start(self, script: str, name: str = 'program-1', *words: str, **spec: Any) -> Process:
        def on_output(stream: str, text: str) -> None:
            self.log.append((self.sim.elapsed_s, name, text))

        process = self.host.start(
            ProcessSpec(argv=(script, *words), name=name, **spec), on_output, lambda code: self.codes.__setitem__(name, code)
        )
        assert isinstance(process, Process)
        return process

    def run(self, text: str, name: str = 'program-1', *words: str, seconds: float = 1000) -> str:
        """Write a script, run it alone, and return all that it wrote."""
        self.start(self.write(f'{name}.py', text), name, *words)
        self.sim.run(self.sim.now_ns + round(seconds * 1e9))
        return ''.join(text for _, who, text in self.log if who == name)


@pytest.fixture
def world(tmp_path: Path) -> World:
    return World(tmp_path)


@pytest.fixture
def make_world(tmp_path: Path) -> Callable[[int], World]:
    return lambda seed: World(tmp_path, seed)
