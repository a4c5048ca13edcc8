"""Programs that read the keyboard of a real terminal."""

from __future__ import annotations

import shlex
import signal
import subprocess
import termios
from collections.abc import Callable

import pytest

from tests.desk.machine.shells import PATIENCE_S, ROS2, Desk, Shell
from tests.desk.machine.workspace import make_package

ASKS = """def main():
    name = input('Name? ')
    print(f'Hello {name}')
    print('Sum:', sum(int(input()) for _ in range(2)))
"""
KEYS = """import os
import select
import sys
import termios
import tty


def main():
    print('a terminal:', sys.stdin.isatty(), sys.stdout.isatty(), os.get_terminal_size().columns)
    before = termios.tcgetattr(sys.stdin)
    tty.setraw(sys.stdin.fileno())
    try:
        while True:
            ready, _, _ = select.select([sys.stdin], [], [], 0.1)
            key = sys.stdin.read(1) if ready else ''
            if key == 'q' or key == chr(3):
                break
            if key:
                print(f'key {key!r}')
    finally:
        termios.tcsetattr(sys.stdin, termios.TCSADRAIN, before)
"""


@pytest.fixture
def run(desk: Desk) -> Callable[[str, str], Shell]:
    """`ros2 run mine NAME`, for a program with that text."""

    def start(name: str, text: str) -> Shell:
        make_package(desk.folder, {name: text})
        return desk.ros2(f'run mine {name}')

    return start


def is_plain(shell: Shell) -> bool:
    """Whether the terminal gives lines, shows what is typed, and knows Ctrl-C."""
    flags = termios.ICANON | termios.ECHO | termios.ISIG
    return shell.mode() & flags == flags


def test_input_asks_and_waits(run: Callable[[str, str], Shell]) -> None:
    shell = run('asks', ASKS)
    shell.until('Name? ')
    shell.type('Ada\n')
    shell.until('Hello Ada')
    shell.type('40\n2\n')
    shell.until('Sum: 42')
    assert shell.end() == 0


def test_a_program_may_read_key_by_key_and_take_ctrl_c_as_a_key(run: Callable[[str, str], Shell]) -> None:
    shell = run('keys', KEYS)
    shell.until('a terminal: True True 91')
    shell.wait_for(lambda: not is_plain(shell))
    shell.type('x\x1b')
    shell.until(r"key '\x1b'")
    assert "key 'x'" in shell.output
    shell.type('\x03')
    assert shell.end() == 0 and is_plain(shell)


@pytest.mark.parametrize('signum', [signal.SIGKILL, signal.SIGTERM, signal.SIGHUP])
def test_the_terminal_is_put_right_whatever_ends_the_client(run: Callable[[str, str], Shell], signum: int) -> None:
    shell = run('keys', KEYS)
    shell.until('a terminal')
    shell.wait_for(lambda: not is_plain(shell))
    shell.send(signum)
    shell.end()
    shell.wait_for(lambda: is_plain(shell))


def test_what_nobody_reads_is_left_to_the_next_command(desk: Desk) -> None:
    line = shlex.join([*ROS2, 'topic', 'list'])
    shell = Shell('-c', f'{line}; read word; echo "got $word"', cwd=desk.folder, env=desk.env, program=['/bin/sh'])
    desk.shells.append(shell)
    shell.type('typed ahead\n')
    shell.until('got typed ahead')
    assert '/rosout' in shell.output


def test_a_pipe_and_nothing_at_all_may_be_read(desk: Desk) -> None:
    make_package(desk.folder, {'asks': ASKS})
    words = [*ROS2, 'run', 'mine', 'asks']
    done = subprocess.run(
        words, input='Ada\n1\n2\n', env=desk.env, cwd=desk.folder, capture_output=True, text=True, timeout=PATIENCE_S
    )
    assert done.stdout == 'Name? Hello Ada\nSum: 3\n'
    closed = ['/bin/sh', '-c', f'{shlex.join(words)} <&-']
    done = subprocess.run(closed, env=desk.env, cwd=desk.folder, capture_output=True, text=True, timeout=PATIENCE_S)
    assert 'EOFError' in done.stderr


def test_a_reader_that_goes_away_ends_the_command_quietly(desk: Desk) -> None:
    desk.ros2('run demo_nodes_py talker').until('Publishing')
    line = f'{shlex.join([*ROS2, "topic", "echo", "/chatter"])} | head -n 1; echo over'
    done = subprocess.run(
        ['/bin/sh', '-c', line], env=desk.env, cwd=desk.folder, capture_output=True, text=True, timeout=PATIENCE_S
    )
    assert done.stdout.endswith("'\nover\n") and done.stderr == ''
