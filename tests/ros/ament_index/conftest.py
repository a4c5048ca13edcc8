"""Code that runs inside a simulated process with an index of its own."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from edulaunch.engine.graph.graph import Graph
from edulaunch.engine.packages import Index
from edulaunch.engine.processes.host import Host
from edulaunch.engine.processes.process import Process
from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.engine.sim.simulation import Simulation


def make_prefix(path: Path, *packages: str) -> Path:
    """An install prefix with empty packages."""
    for package in packages:
        marker = path / 'share/ament_index/resource_index/packages' / package
        marker.parent.mkdir(parents=True, exist_ok=True)
        marker.write_text('', encoding='utf-8')
        (path / 'share' / package).mkdir(exist_ok=True)
    return path


def run_inside(index: Index, body: Callable[[], Any]) -> Any:
    """The result of `body`, or the exception it raised, run as a program of a simulation with `index`."""
    sim = Simulation()
    host = Host(sim, Graph(sim), index, env={})
    answers: list[Any] = []

    def main(process: Process) -> None:
        try:
            answers.append(body())
        except Exception as error:
            answers.append(error)

    host.adopt(Process(host, ProcessSpec(argv=('test',)), 1, ['test'], main))
    sim.run()
    return answers[0]


@pytest.fixture
def two_prefixes(tmp_path: Path) -> tuple[str, str]:
    return str(make_prefix(tmp_path / 'over', 'alpha', 'beta')), str(make_prefix(tmp_path / 'under', 'alpha', 'gamma_robot'))


@pytest.fixture
def ask(two_prefixes: tuple[str, str]) -> Callable[[Callable[[], Any]], Any]:
    index = Index(two_prefixes, underlay=None)
    return lambda body: run_inside(index, body)
