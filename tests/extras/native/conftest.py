"""Tests on the real rclpy are skipped where it is not installed."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from edulaunch.extras.native import environment
from tests.extras.network.wires import own_domain
from tests.house import ROOT

Run = Callable[..., subprocess.CompletedProcess[str]]
LONGEST_S = 120


@pytest.fixture
def real(monkeypatch: pytest.MonkeyPatch) -> Iterator[environment.Environment]:
    """The environment of the real rclpy, in a domain of this test's own, on this computer only."""
    found = environment.found()
    if found is None:
        pytest.skip('the real rclpy is not installed: edulaunch network install')
    monkeypatch.setenv('ROS_AUTOMATIC_DISCOVERY_RANGE', 'LOCALHOST')
    with own_domain() as domain:
        monkeypatch.setenv('ROS_DOMAIN_ID', str(domain))
        yield found


@pytest.fixture
def edulaunch(tmp_path: Path) -> Run:
    """Run the command as in an active terminal, whose PYTHONPATH leads to the simulated rclpy; what it prints is text."""
    simulated = os.pathsep.join(str(ROOT / 'edulaunch' / 'ros' / name) for name in ('shell', 'python'))

    def run(*words: str) -> subprocess.CompletedProcess[str]:
        env = {**os.environ, 'PYTHONPATH': simulated}
        command = [sys.executable, '-m', 'edulaunch', *words]
        nothing = subprocess.DEVNULL
        return subprocess.run(command, capture_output=True, text=True, cwd=tmp_path, timeout=LONGEST_S, stdin=nothing, env=env)

    return run
