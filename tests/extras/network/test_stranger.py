"""Another computer that names us in ROS_STATIC_PEERS sees nothing and drives nothing while we are on this computer alone."""

from __future__ import annotations

import json
import subprocess
import sys
from typing import Any

import pytest

from edulaunch.extras.native import environment
from tests.extras.network.test_two_computers import ALONE
from tests.extras.network.test_two_computers import own_network as own_network
from tests.house import ROOT

NOTHING = {'driven': False, 'code': 0, 'heard': 0, 'nodes': []}


def met(kind: str, wide: str) -> Any:
    """What the stranger saw of us, and whether he reached us."""
    words = [*ALONE, '-m', sys.executable, '-m', 'tests.extras.network.stranger', kind, wide]
    done = subprocess.run(words, cwd=ROOT, capture_output=True, text=True, timeout=240, check=False)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout.splitlines()[-1])


@pytest.mark.processes
def test_the_default_link_on_this_computer_alone() -> None:
    """Its sockets are bound to the device: what it does not announce would otherwise still receive packets."""
    assert met('cyclonedds', 'LOCALHOST') == {**NOTHING, 'open': 0}


@pytest.mark.processes
def test_the_stranger_of_the_default_link_can_hear() -> None:
    found = met('cyclonedds', 'SUBNET')
    assert (found['driven'], found['heard'] > 0, 'ours' in found['nodes'], found['open'] > 0) == (True, True, True, True)


@pytest.mark.real
@pytest.mark.parametrize('kind', ['rclpy', 'real', 'compare'])
def test_what_is_on_the_real_rclpy_on_this_computer_alone(kind: str) -> None:
    if environment.found() is None:
        pytest.skip('the real rclpy is not installed: edulaunch network install')
    """Fast DDS sends from a socket that nobody reads, so that packets arrive there without effect."""
    found = met(kind, 'LOCALHOST')
    found.pop('open', None)
    assert found == NOTHING


@pytest.mark.real
@pytest.mark.parametrize('kind', ['rclpy', 'real'])
def test_the_stranger_on_the_real_rclpy_can_hear(kind: str) -> None:
    if environment.found() is None:
        pytest.skip('the real rclpy is not installed: edulaunch network install')
    found = met(kind, 'SUBNET')
    assert (found['driven'], found['heard'] > 0) == (True, True)
