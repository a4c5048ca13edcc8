"""Over a cable between two namespaces of the network, as between two computers."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from typing import Any

import pytest

from edulaunch.extras.native import environment
from tests.house import ROOT

ALONE = ('unshare', '-rn')
CARD = (
    f'import os, sys; sys.path.insert(0, {str(ROOT)!r}); from tests.extras.network.cable import card; card("near", "10.99.0.1")'
)


def pair(link: str, wide: str, lost: int, delay_ms: int) -> Any:
    """What the second computer heard of the first."""
    words = [*ALONE, sys.executable, '-m', 'tests.extras.network.two_computers', link, wide, str(lost), str(delay_ms)]
    done = subprocess.run(words, cwd=ROOT, capture_output=True, text=True, timeout=300, check=False)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


@pytest.fixture(autouse=True)
def own_network(domain: int) -> None:
    if (
        shutil.which('unshare') is None
        or subprocess.run([*ALONE, sys.executable, '-c', CARD], capture_output=True, check=False).returncode
    ):
        pytest.skip(
            'no namespaces of the network here: they want unshare, ip (iproute2), /dev/net/tun and the permission to use them'
        )


@pytest.mark.processes
@pytest.mark.parametrize(('wide', 'lost', 'delay_ms'), [('SUBNET', 0, 0), ('SUBNET', 100, 0), ('LOCALHOST', 10, 50)])
def test_all_that_is_reliable_arrives_over_a_cable_that_is_slow_and_loses_packets(wide: str, lost: int, delay_ms: int) -> None:
    """On LOCALHOST the two know each other by ROS_STATIC_PEERS."""
    found = pair('cyclonedds', wide, lost, delay_ms)
    assert (found['reliable'], found['answered'], found['nodes']) == (True, True, [['talker', True]])
    assert (found['dropped'] > 0) == (lost > 0)
    assert 300 <= found['best_effort'] < (500 if lost == 100 else 501)
    assert found['tf'] >= 300 and found['tf_in_order']
    assert delay_ms <= found['tf_late_ms'][0] <= found['tf_late_ms'][1] < 10_000, 'older is nothing in a buffer of tf2'


@pytest.mark.real
def test_the_full_link_over_such_a_cable() -> None:
    if environment.found() is None:
        pytest.skip('the real rclpy is not installed: edulaunch network install')
    found = pair('rclpy', 'SUBNET', 10, 50)
    assert (found['reliable'], found['answered'], found['nodes'], found['tf_in_order']) == (True, True, [['talker', True]], True)
    assert found['dropped'] > 0 and found['best_effort'] >= 300
    assert 50 <= found['tf_late_ms'][0] <= found['tf_late_ms'][1] < 10_000
