"""The runner's end of the starter: begins runs in it, and hears what became of them."""

from __future__ import annotations

import json
import os
import socket
import subprocess
import sys
from select import select

from .addresses import same_addresses
from .job import Job, environment, import_path

_STARTER = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'starter.py')
LENGTH_BYTES = 4
PATIENCE_S = 20.0  # for the starter to load the engine


class StarterLink:
    """A starter process.

    :param home: a private folder for it.

    :ivar pids: process id of each run that has begun, by its number.
    :ivar statuses: exit code (negative: the signal) of each run that has ended by itself, by its number.
    :ivar is_alive: whether it can still be talked to. A hostile submission may have killed it.
    """

    def __init__(self, home: str) -> None:
        self.pids: dict[int, int] = {}
        self.statuses: dict[int, int] = {}
        self.is_alive = True
        self._heard = b''
        self.socket, theirs = socket.socketpair()
        settings = json.dumps({'control': theirs.fileno(), 'path': import_path()})
        with theirs, same_addresses():
            self._process = subprocess.Popen(
                [sys.executable, '-s', '-S', _STARTER, settings],
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL,
                pass_fds=(theirs.fileno(),),
                cwd=home,
                env={**environment(home), 'PYTHONSAFEPATH': '1'},
                start_new_session=True,
            )

    def begin(self, number: int, job: Job, channel: int, output: int) -> None:
        """Begin a run, which answers on `channel` and prints on `output`."""
        self._say({'run': number, 'job': job.message}, [channel, output])

    def reap(self, pid: int) -> None:
        """Let the system forget a run that has been ended."""
        self._say({'reap': pid})

    def hear(self) -> None:
        """Take in what the starter has to say; only when its socket is ready, or this waits."""
        try:
            data = self.socket.recv(1 << 16)
        except OSError:
            data = b''
        if not data:
            self.is_alive = False
        self._heard += data
        while len(self._heard) >= LENGTH_BYTES:
            end = LENGTH_BYTES + int.from_bytes(self._heard[:LENGTH_BYTES], 'big')
            if len(self._heard) < end:
                return
            self._note(json.loads(self._heard[LENGTH_BYTES:end]))
            self._heard = self._heard[end:]

    def pid_of(self, number: int) -> int | None:
        """The process id of a run; waits until it has begun. None when the starter is gone."""
        while self.is_alive and number not in self.pids:
            if not select([self.socket], [], [], PATIENCE_S)[0]:
                self.is_alive = False
                break
            self.hear()
        return self.pids.get(number)

    def close(self) -> None:
        """End the starter, and with it every run that has not been ended."""
        self.socket.close()  # it ends its runs when it notices
        try:
            self._process.wait(1.0)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()

    def _say(self, message: dict[str, object], descriptors: list[int] | None = None) -> None:
        data = json.dumps(message).encode()
        header = len(data).to_bytes(LENGTH_BYTES, 'big')
        try:
            if descriptors:
                socket.send_fds(self.socket, [header], descriptors)
                self.socket.sendall(data)
            else:
                self.socket.sendall(header + data)
        except OSError:
            self.is_alive = False

    def _note(self, message: dict[str, int]) -> None:
        if 'pid' in message:
            self.pids[message['run']] = message['pid']
        else:
            self.statuses[message['run']] = message['status']
