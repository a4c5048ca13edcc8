"""The same launch file, arguments and seed give the same recording, byte for byte."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
PROGRAM = f"""
import sys
sys.path.insert(0, {str(ROOT)!r})
import edulaunch
for package, file, arguments in (
        ('turtle_tf2_py', 'turtle_tf2_fixed_frame_demo.launch.py', {{}}),
        ('tuos_simulations', 'waffle.launch.py', {{'x_pose': '1.0'}}),
        ('demo_nodes_cpp', 'talker_listener_launch.py', {{}})):
    print(edulaunch.run(package, file, arguments=arguments, duration_s=8.0, seed=int(sys.argv[1])).digest())
"""


def digests(python: str, hash_seed: str, seed: int = 0) -> list[str]:
    done = subprocess.run(
        [python, '-c', PROGRAM, str(seed)],
        capture_output=True,
        text=True,
        check=True,
        env={**os.environ, 'PYTHONHASHSEED': hash_seed},
    )
    return done.stdout.split()


@pytest.mark.processes
def test_two_processes_with_different_hash_seeds_give_the_same_digests() -> None:
    first = digests(sys.executable, '1')
    assert first == digests(sys.executable, '2') and len(set(first)) == 3


@pytest.mark.processes
def test_another_python_gives_the_same_digests() -> None:
    others = [python for python in os.environ.get('EDULAUNCH_PYTHONS', '').split(os.pathsep) if python]
    if not others:
        pytest.skip('EDULAUNCH_PYTHONS names no other Python (.ci/run does)')
    expected = digests(sys.executable, '3')
    assert {python: digests(python, '4') for python in others} == dict.fromkeys(others, expected)
