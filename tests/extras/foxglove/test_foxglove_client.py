"""Foxglove's own client library, from npm, reads, drives, asks and sets what `edulaunch view --foxglove` serves."""

from __future__ import annotations

import json
import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest

pytest.importorskip('tornado')

from tests.desk.machine.conftest import desk_in
from tests.desk.machine.shells import Desk
from tests.extras.foxglove.client import OLD, SDK
from tests.extras.foxglove.test_view import view

PACKAGES = ('@foxglove/ws-protocol@0.8.0', '@foxglove/rosmsg@5.0.5', '@foxglove/rosmsg2-serialization@3.1.0', 'ws@8.18.3')
PROGRAM = Path(__file__).with_name('foxglove_client.cjs')
PATIENCE_S = 120
ABILITIES = ['clientPublish', 'connectionGraph', 'parameters', 'parametersSubscribe', 'services', 'time']


@pytest.fixture
def desk(tmp_path: Path) -> Iterator[Desk]:
    yield from desk_in(tmp_path)


@pytest.fixture(scope='module')
def program(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The client in a folder with its packages."""
    npm = shutil.which('npm')
    if npm is None or shutil.which('node') is None:
        pytest.skip('no Node.js on this machine: apt-get install nodejs npm')
    folder = tmp_path_factory.mktemp('npm')
    words = [npm, 'install', '--ignore-scripts', '--no-audit', '--no-fund', '--prefix', str(folder), *PACKAGES]
    try:
        done = subprocess.run(words, cwd=folder, capture_output=True, check=False, timeout=PATIENCE_S)
    except subprocess.TimeoutExpired:
        pytest.skip('npm does not answer')
    if done.returncode:
        pytest.skip("Foxglove's client cannot be had from npm")
    return Path(shutil.copy(PROGRAM, folder))


@pytest.mark.terminals
def test_the_client_library_of_foxglove_with_both_subprotocols(desk: Desk, program: Path) -> None:
    desk.ros2('run turtlesim turtlesim_node').until('Spawning turtle')
    _, url = view(desk)
    for number, (protocol, name) in enumerate(((SDK, 'of_sdk'), (OLD, 'of_websocket'))):
        done = subprocess.run(['node', program, url, protocol], capture_output=True, text=True, timeout=PATIENCE_S)
        assert done.returncode == 0, done.stdout + done.stderr
        assert json.loads(done.stdout) == {
            'capabilities': ABILITIES,
            'publishers': ['/turtlesim'],
            'before': 69 + number,
            'spawned': name,
            'failures': ['this server has no service 99999'],
        }
