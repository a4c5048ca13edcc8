"""One run as the runner handles it: the starter starts the run, the runner reads its answer, and the guard ends its processes."""

from __future__ import annotations

import json
import os
import signal
import socket
from contextlib import ExitStack, suppress
from time import monotonic

from .job import MEBI, RunRequest
from .readiness import is_readable
from .sandbox.trusted_peer import send
from .starter_link import StarterLink

LETTERS = b'RUSB'  # types of the frame with the answer; sandbox/child.py explains them
CONFINED = b'C'  # type of the frame before the answer
HEADER_BYTES = 9
CHUNK_BYTES = 1 << 18
PATIENCE_S = 20.0  # time limit for the starter to load the engine
KEPT_OUTPUT_BYTES = 8000
LONGEST_STATE_BYTES = 4000
GUARD_S = 5.0  # time limit for the guard to end all processes of the run
GRACE_S = 1.0  # time limit to answer after the child's own alarm, or to end after it has closed the channel


class ChildRun:
    """A run of one scenario. `channel` and `output` are the read ends of its pipes, and `link` is the socket to its guard.

    :ivar sandbox: for each layer of the sandbox 'held' or the reason of its failure. It has the value None until the run has
        reported the layers, and {} for a run without a sandbox.
    """

    def __init__(self, job: RunRequest, starter: StarterLink) -> None:
        self.scenario = job.scenario
        self.submission = job.submission
        self.home = job.home
        self.starter = starter
        self.workspaces = job.workspaces
        self.limits = job.limits
        self.frame = bytearray()
        self.printed = bytearray()  # first part of the output; printed_bytes counts all of it
        self.printed_bytes = 0
        self.sandbox: dict[str, str] | None = None
        self.cut: str | None = None  # the limit that ended it: wall, printed, recording, garbage, processes, memory or disk
        self.let_go = False  # whether the child closed its end of the channel
        self.refused: list[str] = []  # names of system calls
        self.returncode: int | None = None
        self.is_over = False  # whether the guard has ended the child and all its processes
        self._reported = b''
        self._pids: list[int] = []
        with ExitStack() as ends, ExitStack() as failed:
            self.channel, channel_end = (end.detach() for end in socket.socketpair())
            ends.callback(os.close, channel_end)
            failed.callback(os.close, self.channel)
            self.output, output_end = os.pipe()
            ends.callback(os.close, output_end)
            failed.callback(os.close, self.output)
            self.link = starter.begin(job, channel_end, output_end)
            failed.callback(self.link.close)  # at which the guard ends the run
            with suppress(BrokenPipeError, ConnectionResetError):  # the end of the starter is noticed elsewhere
                send(self.channel, b'H', json.dumps(job.scenario.hidden).encode())
            failed.pop_all()
        self.deadline = monotonic() + job.limits.wall_s + GRACE_S + PATIENCE_S
        self.has_begun = False
        self.begun_at = monotonic()

    @property
    def complete(self) -> bool:
        """Whether a complete frame has arrived."""
        return len(self.frame) >= HEADER_BYTES and len(self.frame) >= HEADER_BYTES + self.announced

    @property
    def announced(self) -> int:
        """The length that the header of the frame states, or 0 while the header is incomplete."""
        return int.from_bytes(self.frame[1:HEADER_BYTES], 'big') if len(self.frame) >= HEADER_BYTES else 0

    @property
    def finished(self) -> bool:
        """Whether the child has answered, has ended, or must be ended."""
        return self.complete or self.cut is not None or (self.is_over and not self._more_to_read())

    @property
    def was_killed(self) -> bool:
        """Whether another process killed the child, its guard or the starter, or Python crashed, perhaps because the memory was
        full.

        An end before the child has read the submission counts as well, because the submission cannot have caused it.
        """
        if self.sandbox is None and self.cut != 'wall':
            return True
        if self.complete or self.cut is not None:
            return False
        return self.returncode is None or -self.returncode in (signal.SIGKILL, signal.SIGSEGV, signal.SIGABRT)

    def read_channel(self) -> bool:
        """Read data that the child has sent. Return False if the child has closed the channel."""
        data = b''
        with suppress(ConnectionResetError):  # the child ended before it read what it must know
            data = os.read(self.channel, CHUNK_BYTES)
        self.frame += data
        if self.sandbox is None and self.frame[:1] == CONFINED:
            self._take_state()
        elif self.frame and self.frame[0] not in LETTERS:
            self.cut = 'garbage'
        elif max(len(self.frame), self.announced) > self.limits.recording_mib * MEBI:
            self.cut = 'recording'
        if not data:
            self.let_go = True
            self.deadline = min(self.deadline, monotonic() + GRACE_S)
        return bool(data)

    def read_output(self) -> bool:
        """Read output of the child. Return False if no process can write to this pipe any more."""
        data = os.read(self.output, CHUNK_BYTES)
        self.printed_bytes += len(data)
        if len(self.printed) < KEPT_OUTPUT_BYTES:
            self.printed += data
        if self.printed_bytes > self.limits.output_mib * MEBI:
            self.cut = 'printed'
        return bool(data)

    def read_link(self) -> bool:
        """Read messages of the guard. Return False if the guard, and so the run, has ended.

        The first message starts the time limit of the run.
        """
        data = b''
        with suppress(OSError):
            data = self.link.recv(CHUNK_BYTES)
        self._reported += data
        *lines, self._reported = self._reported.split(b'\n')
        for line in lines:
            message = json.loads(line)
            self.returncode = message.get('status', self.returncode)
            self.cut = self.cut or message.get('cut')
            self.refused = message.get('refused', self.refused)
            if not self.has_begun and 'guard' in message:  # the guard may fail before it can say this
                self._pids = [message['guard'], message['pid']]
                self.has_begun = True
                self.begun_at = monotonic()
                self.deadline = monotonic() + self.limits.wall_s + GRACE_S
        self.is_over = not data
        return bool(data)

    def watch(self) -> None:
        """If the deadline has passed, record this."""
        if self.cut is None and not self.complete and monotonic() > self.deadline:
            self.cut = 'wall'

    def end(self) -> None:
        """Make the guard end the run with all its processes. When this method returns, no process of the run exists."""
        with suppress(OSError):
            self.link.shutdown(socket.SHUT_WR)
        deadline = monotonic() + GUARD_S
        while not self.is_over and monotonic() < deadline:
            if is_readable(self.link, GUARD_S):
                self.read_link()
        if not self.is_over and self._pids:  # the guard was stopped, which only an unconfined run can do
            for pid in self._pids:
                with suppress(OSError):
                    os.kill(pid, signal.SIGKILL)
        self.link.close()
        os.close(self.channel)
        os.close(self.output)

    def _take_state(self) -> None:
        """Remove the first frame, which reports the layers of the sandbox. The child sends it before it reads the submission."""
        if self.announced > LONGEST_STATE_BYTES:
            self.cut = 'garbage'
        elif self.complete:
            end = HEADER_BYTES + self.announced
            try:
                self.sandbox = dict(json.loads(self.frame[HEADER_BYTES:end]))
                del self.frame[:end]
            except (ValueError, TypeError):
                self.cut = 'garbage'

    def _more_to_read(self) -> bool:
        return not self.let_go and is_readable(self.channel, 0)
