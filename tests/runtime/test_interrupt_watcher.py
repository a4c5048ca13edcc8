"""Ctrl-C while a call of C code keeps Python's interpreter: the process beside the run answers."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

import pytest

from edulaunch.runtime.interrupt_watcher import WatchedSignals, innermost_own, watched_signals

pytestmark = pytest.mark.skipif(not hasattr(signal, 'SIGUSR1'), reason='no such signal on this system')

RUN = """import itertools
import os
import signal
import sys

from edulaunch.runtime.interrupt_watcher import watched_signals


def press(signum, frame):
    watched.confirm()
    raise KeyboardInterrupt


with watched_signals((sys.prefix, sys.base_prefix)) as watched:
    signal.signal(signal.SIGINT, press)
    signal.signal(signal.SIGTERM, press)
    try:
        {work}
    except KeyboardInterrupt:
        print('interrupted', file=sys.stderr)
"""
IN_C = 'sum(itertools.chain(map(os.write, [1], [b"ready\\n"]), range(10**12)))'
"""It says that it runs from within C code, so that a signal after that finds no Python."""
IN_PYTHON = 'while True: os.write(1, b"ready\\n")'
TRACEBACK = """Current thread 0x1 (most recent call first):
  File "/usr/lib/python3.11/re.py", line 7 in match
  File "<string>", line 1 in <module>
  File "/home/ada/turtle.py", line 14 in drive
  File "/home/ada/turtle.py", line 20 in <module>
"""


def test_the_place_is_the_innermost_of_the_students_own() -> None:
    assert innermost_own(TRACEBACK, ('/usr/lib/',)) == '/home/ada/turtle.py:14 (drive)'
    assert innermost_own(TRACEBACK.replace('in drive', 'in <module>'), ('/usr/lib/',)) == '/home/ada/turtle.py:14'
    assert innermost_own(TRACEBACK, ('/usr/lib/', '/home/')) == ''


@pytest.mark.processes
def test_after_the_block_nothing_is_written_into_a_file_of_the_same_number(tmp_path: Path) -> None:
    before = signal.set_wakeup_fd(-1)
    signal.set_wakeup_fd(before)
    with watched_signals(()) as watched:
        watched.confirm()
    with ExitStack() as opened:
        for number in range(8):  # they get the numbers that are free
            opened.enter_context(open(tmp_path / str(number), 'wb'))
        watched.confirm()
    assert [file.read_bytes() for file in sorted(tmp_path.iterdir())] == [b''] * 8
    assert signal.set_wakeup_fd(before) == before


def test_without_a_watcher_nothing_is_confirmed() -> None:
    WatchedSignals().confirm()


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / 'run.py').write_text(RUN.format(work=IN_C))
    return tmp_path


@contextmanager
def started(folder: Path) -> Iterator[subprocess.Popen[str]]:
    """A run that has begun. It is killed at the end, also when an assertion fails."""
    env = {**os.environ, 'PYTHONPATH': os.pathsep.join(sys.path)}
    command = [sys.executable, 'run.py']
    with subprocess.Popen(command, cwd=folder, env=env, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as run:
        try:
            assert run.stdout is not None and run.stdout.readline() == 'ready\n'
            yield run
        finally:
            run.kill()


def lines(run: subprocess.Popen[str]) -> Iterator[str]:
    assert run.stderr is not None
    yield from (line.strip() for line in run.stderr if line.strip())


@pytest.mark.processes
def test_each_press_is_answered_and_the_third_one_ends_the_run(folder: Path) -> None:
    with started(folder) as run:
        answers, place = lines(run), f'a program at {folder}/run.py:18'
        can_not = f'note: {place} is in a call that Python cannot interrupt; press Ctrl-C'
        run.send_signal(signal.SIGINT)
        assert next(answers) == f'{can_not} twice more to kill the run'
        run.send_signal(signal.SIGINT)
        assert next(answers) == f'{can_not} once more to kill the run'
        run.send_signal(signal.SIGINT)
        assert next(answers) == f'error: {place} cannot be interrupted: the run was killed'
        assert run.wait() == -signal.SIGKILL


@pytest.mark.processes
def test_a_run_that_does_not_end_on_sigterm_is_killed(folder: Path) -> None:
    with started(folder) as run:
        run.send_signal(signal.SIGTERM)
        place = f'a program at {folder}/run.py:18'
        assert next(lines(run)) == f'error: {place} prevents the end of the run: the run was killed'
        assert run.wait() == -signal.SIGKILL


@pytest.mark.processes
def test_python_answers_for_itself_where_it_can(folder: Path) -> None:
    (folder / 'run.py').write_text(RUN.format(work=IN_PYTHON))
    with started(folder) as run:
        run.send_signal(signal.SIGINT)
        assert list(lines(run)) == ['interrupted'] and run.wait() == 0
