"""The small world of scripts, on a machine with a shell."""

from __future__ import annotations

from pathlib import Path

import pytest

from edulaunch.engine.processes.commands import CommandSet
from edulaunch.runtime.shell import SimulatedShell
from tests.engine.processes.conftest import World


@pytest.fixture
def world(tmp_path: Path) -> World:
    found = World(tmp_path)
    found.host.command_set = CommandSet(shell=SimulatedShell())
    return found
