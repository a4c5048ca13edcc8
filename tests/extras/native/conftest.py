"""Tests on the real rclpy are skipped where it is not installed."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from edulaunch.extras.native import environment
from tests.extras.network.wires import own_domain

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
    """Run the command; what it prints is text."""

    def run(*words: str) -> subprocess.CompletedProcess[str]:
        command = [sys.executable, '-m', 'edulaunch', *words]
        return subprocess.run(command, capture_output=True, text=True, cwd=tmp_path, timeout=LONGEST_S, stdin=subprocess.DEVNULL)

    return run
