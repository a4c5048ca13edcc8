"""Real terminals for tests: commands in ptys, read until what is waited for has come."""

from __future__ import annotations

import fcntl
import os
import pty
import select
import signal
import struct
import sys
import termios
import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Any

from edulaunch.desk.machine.place import installation

PATIENCE_S = 240.0
"""Real seconds after which something will never come, however busy the computer is; nothing is measured by it."""
ROS2 = [sys.executable, '-c', 'import sys; from edulaunch.desk.machine.command import ros2; sys.exit(ros2())']


class Shell:
    """A command in a terminal of its own."""

    def __init__(self, *words: str, cwd: Path, env: dict[str, str], program: list[str] = ROS2) -> None:
        self.pid, self.number = pty.fork()
        if self.pid == 0:
            os.chdir(cwd)
            os.execve(program[0], [*program, *words], env)
        fcntl.ioctl(self.number, termios.TIOCSWINSZ, struct.pack('HHHH', 31, 91, 0, 0))
        self.words = words
        self.output = ''
        self.code: int | None = None

    def mode(self) -> int:
        """Local flags of the terminal."""
        return int(termios.tcgetattr(self.number)[3])

    def type(self, text: str) -> None:
        """Press keys."""
        os.write(self.number, text.encode())

    def read(self, seconds: float) -> bool:
        """Take what comes within some time; False when nothing did."""
        ready = select.poll()  # not `select.select`, which knows no numbers above 1023
        ready.register(self.number, select.POLLIN | select.POLLHUP)
        if not ready.poll(seconds * 1000):
            return False
        try:
            data = os.read(self.number, 1 << 16)
        except OSError:
            data = b''
        self.output += data.decode('utf-8', 'replace')
        return bool(data)

    def until(self, ready: str | Callable[[str], Any], seconds: float = PATIENCE_S) -> str:
        """Read until a text, or what a function looks for, has come; returns all output."""
        found = (lambda output: ready in output) if isinstance(ready, str) else ready
        deadline = time.monotonic() + seconds
        while not found(self.output):
            left = deadline - time.monotonic()
            assert left > 0, f'{self.words}: waited for {ready!r}, got {self.output!r}'
            if not self.read(left) and self.gone():
                break
        assert found(self.output), f'{self.words}: ended before {ready!r} came: {self.output!r}'
        return self.output

    def wait_for(self, ready: Callable[[], Any], seconds: float = PATIENCE_S) -> None:
        """Read on until something is so."""
        deadline = time.monotonic() + seconds
        while not ready():
            assert time.monotonic() < deadline, f'{self.words}: {self.output!r}'
            if not self.read(0.01):
                select.select([], [], [], 0.01)

    def gone(self) -> bool:
        """Whether the command has ended."""
        if self.code is None:
            pid, status = os.waitpid(self.pid, os.WNOHANG)
            self.code = os.waitstatus_to_exitcode(status) if pid else None
        return self.code is not None

    def end(self, seconds: float = PATIENCE_S) -> int:
        """Read to the end; returns the exit code."""
        deadline = time.monotonic() + seconds
        while not self.gone():
            assert time.monotonic() < deadline, f'{self.words} does not end: {self.output!r}'
            if not self.read(0.05):
                select.select([], [], [], 0.01)
        while self.read(0):
            pass
        assert self.code is not None
        return self.code

    def send(self, signum: int) -> None:
        """Send a signal to the command itself."""
        if not self.gone():
            os.kill(self.pid, signum)

    def close(self) -> None:
        """Close the window."""
        self.send(signal.SIGKILL)
        if self.code is None:
            os.waitpid(self.pid, 0)
            self.code = -signal.SIGKILL
        os.close(self.number)


class Desk:
    """Terminals of one user and domain, all on one machine.

    :param runtime: where the machine is found.
    """

    def __init__(self, runtime: Path, folder: Path) -> None:
        self.runtime = runtime
        self.folder = folder
        self.env = {
            **{name: value for name, value in os.environ.items() if name in ('PATH', 'HOME', 'LANG', 'PYTHONPATH')},
            'XDG_RUNTIME_DIR': str(runtime),
            'ROS_HOME': str(runtime / 'ros'),
            'EDULAUNCH_GRACE_S': '0.2',
        }
        self.shells: list[Shell] = []

    def ros2(self, line: str, **env: str) -> Shell:
        """Type `ros2 ...` in a new terminal."""
        shell = Shell(*line.split(), cwd=self.folder, env={**self.env, **env})
        self.shells.append(shell)
        return shell

    def said(self, line: str, **env: str) -> str:
        """What a command that ends by itself prints."""
        shell = self.ros2(line, **env)
        shell.end()
        return shell.output.replace('\r\n', '\n')

    @property
    def place(self) -> Path:
        """The folder in which terminals find their machine."""
        return self.runtime / f'edulaunch-{installation()}'

    def log(self) -> str:
        """What the machine complained of."""
        return ''.join(path.read_text() for path in sorted(self.place.glob('*.log')))

    def machine_pid(self, domain: int = 0) -> int:
        """The process that hosts the machine."""
        return int((self.place / f'domain-{domain}').read_text().split('\n')[3])

    def close(self) -> None:
        """Close all terminals and stop the machine."""
        for shell in self.shells:
            shell.close()
        for path in self.place.glob('domain-[0-9]'):
            with suppress(ProcessLookupError, IndexError):
                os.kill(int(path.read_text().split('\n')[3]), signal.SIGTERM)
