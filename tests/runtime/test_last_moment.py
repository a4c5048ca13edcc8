"""The recording of a run that C code ends, or that is killed in C code, is written."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from edulaunch.engine.recording import Recording
from edulaunch.runtime.last_moment import last_moment
from tests.desk.machine.shells import Shell

pytestmark = pytest.mark.skipif(sys.platform == 'win32', reason='no such signals on this system')

LAUNCH = """from launch import LaunchDescription
from launch.actions import ExecuteProcess
def generate_launch_description():
    return LaunchDescription([ExecuteProcess(cmd=['python3', 'turtle.py'], output='screen')])
"""
TURTLE = """import ctypes
import itertools
import rclpy
from std_msgs.msg import Int32
rclpy.init()
node = rclpy.create_node('turtle')
sent = node.create_publisher(Int32, 'sent', 1)
numbers = []
def tick():
    sent.publish(Int32(data=len(numbers)))
    numbers.append(len(numbers))
    if len(numbers) == 4:
        CALL
node.create_timer(0.1, tick)
rclpy.spin(node)
"""
ABORT, WRONG_ADDRESS = 'ctypes.CDLL(None).abort()', 'ctypes.string_at(0)'
ENDLESS = 'sum(itertools.chain(map(ctypes.CDLL(None).write, [2], [b"in C"], [4]), range(10**12)))'
"""It says that it runs from within C code, so that a press after that finds no Python."""
LINE = ('launch', 'one.launch.py', '--fast', '--for', '5', '--record', 'one.recording')


def prepare(folder: Path, call: str) -> dict[str, str]:
    (folder / 'one.launch.py').write_text(LAUNCH)
    (folder / 'turtle.py').write_text(TURTLE.replace('CALL', call))
    return {**os.environ, 'PYTHONPATH': os.pathsep.join(sys.path)}


def assert_kept(folder: Path) -> None:
    recording = Recording.load(folder / 'one.recording')
    assert [message.data for _, message in recording.messages('/sent')] == [0, 1, 2, 3]
    assert sorted(path.name for path in folder.iterdir()) == ['one.launch.py', 'one.recording', 'turtle.py']


@pytest.mark.processes
@pytest.mark.parametrize(('call', 'signum'), [(ABORT, signal.SIGABRT), (WRONG_ADDRESS, signal.SIGSEGV)])
def test_after_a_crash(tmp_path: Path, call: str, signum: signal.Signals) -> None:
    env = prepare(tmp_path, call)
    command = [sys.executable, '-m', 'edulaunch', *LINE]
    run = subprocess.run(command, cwd=tmp_path, env=env, capture_output=True, text=True, check=False)
    assert run.returncode == -signum and run.stderr.endswith('recording: one.recording (to the end of the run in C code)\n')
    assert_kept(tmp_path)


@pytest.mark.terminals
def test_after_three_presses(tmp_path: Path) -> None:
    env = prepare(tmp_path, ENDLESS)
    shell = Shell(*LINE, cwd=tmp_path, env=env, program=[sys.executable, '-m', 'edulaunch'])
    try:
        shell.until('in C')
        for answer in ('twice more to kill the run', 'once more to kill the run', 'the run was killed'):
            shell.type('\x03')
            shell.until(answer)
        shell.until('recording: one.recording')
        assert shell.end() == -signal.SIGKILL
    finally:
        shell.close()
    assert_kept(tmp_path)


def test_the_handler_of_before_is_there_after_the_block() -> None:
    heard: list[int] = []
    before = signal.signal(signal.SIGUSR2, lambda signum, frame: heard.append(signum))
    try:
        with last_moment(lambda: heard.append(0)):
            pass
        signal.raise_signal(signal.SIGUSR2)
    finally:
        signal.signal(signal.SIGUSR2, before)
    assert heard == [signal.SIGUSR2]


ENDLESS_SAVING = """import ctypes
import edulaunch.runtime.last_moment as keeping
keeping.LONGEST_S = 1
def save():
    print('saving', flush=True)
    while True:
        pass
with keeping.last_moment(save):
    ctypes.CDLL(None).abort()
"""
FAILING = """import os, signal, sys
from edulaunch.runtime.last_moment import last_moment
def save():
    print('saving', flush=True)
    1 / 0
with last_moment(save):
    os.kill(os.getpid(), signal.SIGUSR2)
"""


@pytest.mark.processes
@pytest.mark.parametrize(
    ('code', 'signum', 'error'),
    [
        (ENDLESS_SAVING, signal.SIGALRM, ''),
        (FAILING, signal.SIGKILL, 'error: the recording is lost (ZeroDivisionError: division by zero)\n'),
    ],
)
def test_a_process_ends_although_saving_does_not(tmp_path: Path, code: str, signum: signal.Signals, error: str) -> None:
    env = {**os.environ, 'PYTHONPATH': os.pathsep.join(sys.path)}
    run = subprocess.run([sys.executable, '-c', code], cwd=tmp_path, env=env, capture_output=True, text=True, timeout=30)
    assert (run.returncode, run.stdout, run.stderr) == (-signum, 'saving\n', error)


def test_after_the_block_the_signals_do_what_they_did() -> None:
    before = [signal.getsignal(number) for number in (signal.SIGABRT, signal.SIGUSR2)]
    saved: list[str] = []
    seen: list[int] = []
    signal.signal(signal.SIGUSR2, lambda number, frame: seen.append(number))
    try:
        with last_moment(lambda: saved.append('saved')):
            pass
        signal.raise_signal(signal.SIGUSR2)
        assert (saved, seen) == ([], [signal.SIGUSR2])
    finally:
        signal.signal(signal.SIGUSR2, before[1])
