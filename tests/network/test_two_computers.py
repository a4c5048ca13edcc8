"""Over a cable between two namespaces of the network, as between two computers."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys

import pytest

from tests.house import ROOT

ALONE = ('unshare', '-rn')


def works(*words: str) -> bool:
    """Whether a command runs in a namespace of its own."""
    return (
        shutil.which('unshare') is not None and subprocess.run([*ALONE, *words], capture_output=True, check=False).returncode == 0
    )


def pair(wide: str, lost: int, delay_ms: int = 0) -> dict[str, object]:
    """What the second computer heard of the first."""
    words = [*ALONE, sys.executable, '-m', 'tests.network.two_computers', wide, str(lost), str(delay_ms)]
    done = subprocess.run(words, cwd=ROOT, capture_output=True, text=True, timeout=300, check=False)
    assert done.returncode == 0, done.stderr
    found: dict[str, object] = json.loads(done.stdout)
    return found


@pytest.fixture(autouse=True)
def own_network(domain: int) -> None:
    if not works('ip', 'link'):
        pytest.skip('no namespaces of the network here: unshare and ip (iproute2), and the permission to use them')


@pytest.mark.parametrize(('wide', 'lost'), [('SUBNET', 0), ('SUBNET', 10), ('LOCALHOST', 10)])
def test_all_that_is_reliable_arrives_though_a_part_of_the_packets_is_lost(wide: str, lost: int) -> None:
    """On LOCALHOST the two know each other by ROS_STATIC_PEERS."""
    found = pair(wide, lost)
    assert (found['reliable'], found['answered'], found['nodes']) == (True, True, ['talker'])
    assert isinstance(found['best_effort'], int) and found['best_effort'] >= 300


def test_a_cable_that_takes_fifty_milliseconds() -> None:
    if not works('tc', 'qdisc', 'add', 'dev', 'lo', 'root', 'netem', 'delay', '50ms'):
        pytest.skip('the kernel has no netem')
    found = pair('SUBNET', 10, 50)
    assert (found['reliable'], found['answered']) == (True, True)
