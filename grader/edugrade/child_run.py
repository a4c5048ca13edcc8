"""One child process as the runner sees it: start it, collect what it sends, end it with all it started."""

from __future__ import annotations

import os
import signal
from contextlib import suppress
from select import select
from time import monotonic, sleep

from .job import Job
from .limits import MEBI
from .starter_link import PATIENCE_S, StarterLink

LETTERS = b'RUSB'  # of frames; child.py says what they mean
HEADER_BYTES = 9
CHUNK_BYTES = 1 << 18
KEPT_OUTPUT_BYTES = 8000
GROUP_S = 0.2  # for the killed of the process group to be gone
GRACE_S = 1.0  # to answer after its own alarm, or to end after it has let go of the channel


class ChildRun:
    """A scenario on its way. `channel` and `output` are the read ends of its pipes."""

    def __init__(self, job: Job, number: int, starter: StarterLink) -> None:
        self.scenario = job.scenario
        self.limits = job.limits
        self.frame = bytearray()
        self.printed = bytearray()  # the first part of it; printed_bytes counts all
        self.printed_bytes = 0
        self.cut: str | None = None  # 'wall', 'printed', 'recording', 'garbage' or 'starter': what ended it
        self.let_go = False  # whether the child closed its end of the channel
        self.returncode: int | None = None
        self._number = number
        self._starter = starter
        self.channel, channel_end = os.pipe()
        self.output, output_end = os.pipe()
        try:
            starter.begin(number, job, channel_end, output_end)
        finally:
            os.close(channel_end)
            os.close(output_end)
        self.deadline = monotonic() + job.limits.wall_s + GRACE_S + PATIENCE_S
        self._has_begun = False

    @property
    def complete(self) -> bool:
        """Whether one whole frame has come."""
        return len(self.frame) >= HEADER_BYTES and len(self.frame) >= HEADER_BYTES + self.announced

    @property
    def announced(self) -> int:
        """The length that the frame's header announces; 0 while the header is not complete."""
        return int.from_bytes(self.frame[1:HEADER_BYTES], 'big') if len(self.frame) >= HEADER_BYTES else 0

    @property
    def finished(self) -> bool:
        """Whether the child has answered, has ended, or must be ended."""
        return self.complete or self.cut is not None or (self._has_ended() and not self._more_to_read())

    def read_channel(self) -> bool:
        """Take in what the child sent; False when it has let go of the channel."""
        data = os.read(self.channel, CHUNK_BYTES)
        self.frame += data
        if self.frame and self.frame[0] not in LETTERS:
            self.cut = 'garbage'
        elif max(len(self.frame), self.announced) > self.limits.recording_mib * MEBI:
            self.cut = 'recording'
        if not data:
            self.let_go = True
            self.deadline = min(self.deadline, monotonic() + GRACE_S)
        return bool(data)

    def read_output(self) -> bool:
        """Take in what the child printed; False when nobody can print there any more."""
        data = os.read(self.output, CHUNK_BYTES)
        self.printed_bytes += len(data)
        if len(self.printed) < KEPT_OUTPUT_BYTES:
            self.printed += data
        if self.printed_bytes > self.limits.output_mib * MEBI:
            self.cut = 'printed'
        return bool(data)

    def watch(self) -> None:
        """Note when the deadline has come, or when the starter is gone. A run's time begins when it has begun."""
        if not self._has_begun and self._number in self._starter.pids:
            self._has_begun = True
            self.deadline = monotonic() + self.limits.wall_s + GRACE_S
        if self.cut is None and not self.complete:
            if monotonic() > self.deadline:
                self.cut = 'wall'
            elif not self._starter.is_alive:
                self.cut = 'starter'

    def end(self) -> None:
        """Kill the child and its process group, then let the system forget it.

        Nothing of it runs afterwards, unless it left its group on purpose (docs/grading.md says so).
        """
        self.returncode = self._starter.statuses.get(self._number)
        pid = self._starter.pid_of(self._number)
        if pid is not None:
            with suppress(ProcessLookupError, PermissionError):
                os.killpg(pid, signal.SIGKILL)  # before it is reaped: until then the group's number is surely its own
            self._starter.reap(pid)
            _wait_for_the_group(pid)
        os.close(self.channel)
        os.close(self.output)

    def _has_ended(self) -> bool:
        return self._number in self._starter.statuses

    def _more_to_read(self) -> bool:
        return not self.let_go and bool(select([self.channel], [], [], 0)[0])


def _wait_for_the_group(number: int) -> None:
    """A killed process is gone a moment later; wait until the last of the group is (at most GROUP_S)."""
    deadline = monotonic() + GROUP_S
    while monotonic() < deadline:
        try:
            os.killpg(number, 0)
        except (ProcessLookupError, PermissionError):
            return
        sleep(0.001)
