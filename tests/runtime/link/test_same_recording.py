"""The same launch gives the same recording in one process and over the link, byte for byte."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

PROGRAM = Path(__file__).resolve().parent / 'two_peers.py'
AT_LEAST = {'large_project': 1, 'solutions': 11, 'exercises': 5, 'underlay': 25, 'corpus': 60}


GROUPS = [
    'large_project',
    *(pytest.param(group, marks=pytest.mark.whole) for group in ('solutions', 'exercises', 'underlay', 'corpus')),
]


@pytest.mark.processes
@pytest.mark.parametrize('group', GROUPS)
def test_alone_and_over_the_link(group: str) -> None:
    done = subprocess.run([sys.executable, str(PROGRAM), group], capture_output=True, text=True)
    rows = [json.loads(line) for line in done.stdout.splitlines()]
    assert done.returncode == 0, done.stderr
    assert [name for name, alone, linked in rows if alone != linked] == []
    assert len(rows) >= AT_LEAST[group]


@pytest.mark.whole
@pytest.mark.skipif(not (PROGRAM.parents[4] / 'shared' / 'seeds').is_dir(), reason='the seed tutorials are not beside this')
def test_the_seeds() -> None:
    done = subprocess.run([sys.executable, str(PROGRAM), 'seeds'], capture_output=True, text=True)
    rows = [json.loads(line) for line in done.stdout.splitlines()]
    assert done.returncode == 0, done.stderr
    assert [name for name, alone, linked in rows if alone != linked] == []
    assert len(rows) > 40
