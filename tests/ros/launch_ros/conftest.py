"""Launching descriptions whose processes are only noted."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import pytest
from launch import LaunchContext, LaunchDescription, LaunchService

from edulaunch.advice.plan.rehearsal import Notes, RehearsalHost
from edulaunch.engine.graph.graph import Graph
from edulaunch.engine.packages import Index
from edulaunch.engine.processes.process import Process
from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.engine.sim.simulation import Simulation


class Launched:
    """What a launch asked for.

    :ivar specs: of the processes, in the order they were started.
    :ivar logs: [level, logger, text] of warnings and errors.
    :ivar contents: text of each generated parameter file, in order of use.
    """

    def __init__(self) -> None:
        self.specs: list[ProcessSpec] = []
        self.logs: list[list[str]] = []
        self.contents: list[str] = []

    @property
    def words(self) -> list[str]:
        """The command line of the only process after its program, parameter files shortened."""
        (spec,) = self.specs
        return [re.sub(r'.*/launch_params_\w+', 'PARAMS', word) for word in spec.argv[1:]]


def launch(entities: Sequence[Any], index: Index) -> Launched:
    """Launch the entities; every process ends by itself when nothing else is left."""
    result, notes, sim = Launched(), Notes(), Simulation()
    host = RehearsalHost(sim, Graph(sim, notes), index, env={})

    def main(process: Process) -> int:
        service = LaunchService(noninteractive=True)
        service.include_launch_description(LaunchDescription(list(entities)))
        return service.run()

    process = host.run_launch(main)
    sim.run()
    result.specs = [one.spec for one in host.imaginary]
    files: Any = host.generated_files
    result.contents = [files[word].text for spec in result.specs for word in spec.argv if 'launch_params_' in word]
    while process.returncode is None and host.end_next():
        sim.run()
    result.logs = notes.logs
    return result


@pytest.fixture
def robo(tmp_path: Path) -> Index:
    """An index with the package `robo` and its executable `drive`."""
    prefix = tmp_path / 'opt'
    marker = prefix / 'share/ament_index/resource_index/packages/robo'
    marker.parent.mkdir(parents=True)
    marker.write_text('', encoding='utf-8')
    (prefix / 'share/robo').mkdir()
    executable = prefix / 'lib/robo/drive'
    executable.parent.mkdir(parents=True)
    executable.write_text('#!/usr/bin/env python3\n', encoding='utf-8')
    executable.chmod(0o755)
    return Index([prefix], underlay=None)


@pytest.fixture
def run(robo: Index) -> Callable[..., Launched]:
    """launch(*entities) with the package `robo`."""
    return lambda *entities: launch(entities, robo)


@pytest.fixture
def context() -> Callable[..., LaunchContext]:
    """A context with launch configurations."""

    def make(**configurations: str) -> LaunchContext:
        made = LaunchContext()
        made.launch_configurations.update(configurations)
        return made

    return make
