"""The command `edulaunch` as a shell starts it."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from edulaunch.desk.commands import edulaunch
from edulaunch.engine.recording import Recording

LAUNCH = """from launch import LaunchDescription
from launch.actions import ExecuteProcess
def generate_launch_description():
    return LaunchDescription([ExecuteProcess(cmd=['python3', 'sets.py'], output='screen')])
"""
SETS = """print({'ada', 'grace', 'hedy', 'joan', 'katherine'}, hash('radia'))
"""


@pytest.mark.processes
@pytest.mark.skipif(sys.platform == 'win32', reason='Python is not started again there')
def test_sets_of_strings_have_one_order_in_every_launch(tmp_path: Path) -> None:
    (tmp_path / 'one.launch.py').write_text(LAUNCH)
    (tmp_path / 'sets.py').write_text(SETS)
    env = {**os.environ, 'PYTHONPATH': os.pathsep.join(sys.path)}
    env.pop('PYTHONHASHSEED', None)
    digests = set()
    for name in ('first', 'second', 'third'):
        words = ['launch', 'one.launch.py', '--fast', '--for', '1', '--record', name]
        subprocess.run([sys.executable, '-m', 'edulaunch', *words], cwd=tmp_path, env=env, check=True, capture_output=True)
        digests.add(Recording.load(tmp_path / name).digest())
    assert len(digests) == 1


@pytest.mark.processes
def test_the_python_that_starts_again_loads_no_command(tmp_path: Path) -> None:
    """Only the second Python needs the modules of a command, so the first one should not spend time on them."""
    code = 'import sys; import edulaunch.desk.commands; print(*sorted(name for name in sys.modules if "edulaunch" in name))'
    env = {**os.environ, 'PYTHONPATH': os.pathsep.join(sys.path)}
    loaded = subprocess.run(
        [sys.executable, '-c', code], cwd=tmp_path, env=env, check=True, capture_output=True, text=True
    ).stdout
    assert 'edulaunch.desk.commands' in loaded.split()
    assert 'edulaunch.runtime.quiet_start' not in loaded.split()


def test_launch_starts_python_again_with_the_same_words(monkeypatch: pytest.MonkeyPatch) -> None:
    started: list[list[str]] = []

    def start(program: str, words: list[str]) -> None:
        started.append([program, *words, os.environ['PYTHONHASHSEED']])
        raise SystemExit

    monkeypatch.setenv('PYTHONHASHSEED', 'random')
    monkeypatch.delenv('PYTHONHASHSEED')
    monkeypatch.setattr(os, 'execv', start)
    monkeypatch.setattr(sys, 'platform', 'linux')
    monkeypatch.setattr(sys, 'argv', ['edulaunch', 'launch', 'one.launch.py'])
    monkeypatch.setattr(sys, 'orig_argv', ['python', '-m', 'edulaunch', 'launch', 'one.launch.py'])
    with pytest.raises(SystemExit):
        edulaunch()
    assert started == [[sys.executable, sys.executable, '-m', 'edulaunch', 'launch', 'one.launch.py', '0']]


@pytest.mark.parametrize(
    ('words', 'hash_seed', 'platform'),
    [
        (['launch'], '7', 'linux'),
        (['launch'], None, 'win32'),
        (['launch'], None, 'emscripten'),
        (['explain', 'launch'], None, 'linux'),
    ],
)
def test_python_starts_once_where_the_seed_is_set_or_cannot_be(
    monkeypatch: pytest.MonkeyPatch, words: list[str], hash_seed: str | None, platform: str
) -> None:
    monkeypatch.setenv('PYTHONHASHSEED', hash_seed or '')
    if hash_seed is None:
        monkeypatch.delenv('PYTHONHASHSEED')
    monkeypatch.setattr(os, 'execv', lambda program, words: pytest.fail('Python started again'))
    monkeypatch.setattr(sys, 'platform', platform)
    monkeypatch.setattr(sys, 'argv', ['edulaunch', *words])
    monkeypatch.setattr('edulaunch.runtime.quiet_start.run_quietly', lambda module, name: 5)
    assert edulaunch() == 5
