"""The runner's end of the starter: begins runs in it."""

from __future__ import annotations

import json
import os
import socket
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager

from .job import Job, environment, import_path
from .readable import readable_by_all

ADDR_NO_RANDOMIZE = 0x0040000
ASK = 0xFFFFFFFF


@contextmanager
def same_addresses() -> Iterator[None]:
    """Programs that are started inside get no random addresses, where the system allows it (Linux; not in every container)."""
    if not sys.platform.startswith('linux'):
        yield
        return
    import ctypes

    personality = ctypes.CDLL(None).personality
    personality.argtypes = [ctypes.c_ulong]
    before = personality(ASK)
    personality(before | ADDR_NO_RANDOMIZE)
    try:
        yield
    finally:
        personality(before)


_STARTER = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'sandbox', 'starter.py')
LENGTH_BYTES = 4
PATIENCE_S = 20.0  # for the starter to load the engine


class StarterLink:
    """A starter process.

    :param home: a private folder for it.

    :ivar is_alive: whether it can still be talked to.
    """

    def __init__(self, home: str) -> None:
        self.is_alive = True
        self._socket, theirs = socket.socketpair()
        path = import_path()
        readable, listable = readable_by_all(path)
        settings = json.dumps({'path': path, 'readable': readable, 'listable': listable}).encode()
        with theirs, same_addresses():
            self._process = subprocess.Popen(
                [sys.executable, '-s', '-S', _STARTER, str(theirs.fileno())],
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL,
                pass_fds=(theirs.fileno(),),
                cwd=home,
                env={**environment(home), 'PYTHONSAFEPATH': '1'},
                start_new_session=True,
            )
        try:  # not as an argument: of many installed packages these are more than one may hold
            self._socket.sendall(len(settings).to_bytes(LENGTH_BYTES, 'big') + settings)
        except OSError:
            self.is_alive = False

    def begin(self, job: Job, channel: int, output: int) -> socket.socket:
        """Begin a run, which answers on `channel` and prints on `output`. Gives the link to its guard."""
        ours, theirs = socket.socketpair()
        data = json.dumps(job.message).encode()
        with theirs:
            try:
                socket.send_fds(self._socket, [len(data).to_bytes(LENGTH_BYTES, 'big')], [channel, output, theirs.fileno()])
                self._socket.sendall(data)
            except OSError:
                self.is_alive = False
        return ours

    def close(self) -> None:
        """End the starter. It has nothing to do any more: each run has a guard, which ends by itself."""
        self._socket.close()
        self._process.kill()
        self._process.wait()
