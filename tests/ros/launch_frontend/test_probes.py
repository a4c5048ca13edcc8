"""Every answer that ROS 2's own launch gave to the frontend probes is our answer too."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

REPOSITORY = Path(__file__).resolve().parents[3]
PROBES = REPOSITORY.parent / 'shared' / 'probes' / 'launch_probes.py'


def frontend_probes():
    """The expressions in the sections about frontends."""
    if not PROBES.exists():
        return []
    text = PROBES.read_text(encoding='utf-8')
    return text[text.index('# frontend strings') : text.index('# actions\n')].splitlines()


@pytest.fixture(scope='module')
def answers():
    if not PROBES.exists():
        pytest.skip(f'the reference probes are not at {PROBES}')
    path = os.pathsep.join([str(REPOSITORY / 'edulaunch' / 'ros' / 'python'), str(REPOSITORY)])
    done = subprocess.run(
        [sys.executable, str(PROBES)],
        env={**os.environ, 'PYTHONPATH': path},
        capture_output=True,
        text=True,
        check=True,
        timeout=60,
    )
    return json.loads(done.stdout)


@pytest.mark.processes
def test_the_answers_are_the_reference_s(answers):
    reference = json.loads(PROBES.with_suffix('.json').read_text(encoding='utf-8'))
    asked = [probe for probe in frontend_probes() if probe and not probe.startswith('#')]
    assert len(asked) > 55
    assert {probe: answers[probe] for probe in asked} == {probe: reference[probe] for probe in asked}
