"""The grader's end of the connection to a starter (`sandbox/starter.py`), the process that starts the runs.

A starter loads the engine, which takes longer than loading the grader. So the command starts it before anything else.
"""

from __future__ import annotations

import json
import os
import socket
import subprocess
import sys
from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager

from .places import environment, import_path, readable_by_all, shown_to_all
from .sandbox.remove_tree import remove_tree

TYPE_CHECKING = False  # equals `typing.TYPE_CHECKING`, but does not load `typing`
if TYPE_CHECKING:
    from .job import RunRequest

ADDR_NO_RANDOMIZE = 0x0040000
ASK = 0xFFFFFFFF


@contextmanager
def same_addresses() -> Iterator[None]:
    """Start programs in this context without random memory addresses, if the system allows it.

    Linux allows it, except in some containers.
    """
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


STARTER = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'sandbox', 'starter.py')
LENGTH_BYTES = 4


class StarterLink:
    """A starter process and the connection to it.

    :param home: a private folder for the process.
    :ivar is_alive: whether the process still accepts messages.
    :ivar is_for_many: whether the process, before the first run, also loads the modules that only some runs need.
    """

    def __init__(self, home: str) -> None:
        self.is_alive = True
        self.is_for_many = False
        self._socket, theirs = socket.socketpair()
        self._path = import_path()
        self._has_places = False
        with ExitStack() as failed, theirs, same_addresses():
            failed.callback(self._socket.close)
            self._process = subprocess.Popen(
                [sys.executable, '-s', '-S', STARTER, str(theirs.fileno())],
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL,
                pass_fds=(theirs.fileno(),),
                cwd=home,
                env={**environment(home), 'PYTHONSAFEPATH': '1'},
                start_new_session=True,
            )
            failed.pop_all()
        self._send(self._path)  # not as an argument, because many installed packages exceed the length of one argument

    def _send(self, message: object, descriptors: Sequence[int] = ()) -> None:
        data = json.dumps(message).encode()
        header = len(data).to_bytes(LENGTH_BYTES, 'big')
        try:
            if descriptors:
                socket.send_fds(self._socket, [header], descriptors)
            else:
                self._socket.sendall(header)
            self._socket.sendall(data)
        except OSError:
            self.is_alive = False

    def _send_places(self) -> None:
        """Send the paths that every run may read.

        They are sent last, because the starter needs them last. Finding them takes as long as starting the starter.
        """
        self._has_places = True
        readable, listable = readable_by_all(self._path)
        shown, hidden = shown_to_all(self._path)
        self._send(
            {'readable': readable, 'listable': listable, 'shown': shown, 'hidden': hidden, 'is_for_many': self.is_for_many}
        )

    def begin(self, job: RunRequest, channel: int, output: int) -> socket.socket:
        """Start a run, and return the socket to its guard.

        :param channel: the descriptor on which the run sends its answer.
        :param output: the descriptor to which the run writes its output.
        """
        if not self._has_places:
            self._send_places()
        ours, theirs = socket.socketpair()
        with theirs:
            self._send(job.message, [channel, output, theirs.fileno()])
        return ours

    def close(self) -> None:
        """End the starter. Runs continue without it, because each run has a guard that ends by itself."""
        self._socket.close()
        self._process.kill()
        self._process.wait()


def private_folder() -> str:
    """Create a new folder that only this user can enter, and return its path.

    :raises OSError: if the folder cannot be created.
    """
    folder = os.path.join(os.environ.get('TMPDIR') or '/tmp', f'edugrade-{os.urandom(8).hex()}')
    os.mkdir(folder, 0o700)
    return folder


_early: list[tuple[str, StarterLink]] = []


def start_early() -> None:
    """Start a starter for the first runner of this process.

    If this fails, do nothing: the runner then starts a starter, and reports the error.
    """
    with ExitStack() as failed:
        try:
            folder = private_folder()
            failed.callback(remove_tree, folder)
            home = os.path.join(folder, 'starter0')
            os.mkdir(home)
            _early.append((folder, StarterLink(home)))
        except OSError:
            return
        failed.pop_all()


def take_early() -> tuple[str, StarterLink] | None:
    """Return the private folder and the starter that `start_early` created, or None if there is no unused starter. Only one
    runner gets them.
    """
    return _early.pop() if _early else None


def end_early() -> None:
    """End the starter that `start_early` created, unless a runner has taken it."""
    found = take_early()
    if found is not None:
        folder, starter = found
        starter.close()
        remove_tree(folder)
