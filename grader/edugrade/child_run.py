"""One child process as the runner sees it: start it, collect what it sends, end it with all it started."""

from __future__ import annotations

import os
import signal
import subprocess
from select import select
from time import monotonic, sleep

from .job import Job
from .limits import MEBI

LETTERS = b'RUSB'  # of frames; child.py says what they mean
HEADER_BYTES = 9
CHUNK_BYTES = 1 << 18
KEPT_OUTPUT_BYTES = 8000
GROUP_S = 0.2  # for the killed of the process group to be gone
GRACE_S = 1.0  # to answer after its own alarm, or to end after it has let go of the channel


class ChildRun:
    """A scenario on its way. `channel` and `output` are the read ends of its pipes."""

    def __init__(self, job: Job) -> None:
        self.scenario = job.scenario
        self.limits = job.limits
        self.frame = bytearray()
        self.printed = bytearray()      # the first part of it; printed_bytes counts all
        self.printed_bytes = 0
        self.cut: str | None = None     # 'wall', 'printed', 'recording' or 'garbage': what ended it
        self.let_go = False             # whether the child closed its end of the channel
        self.returncode: int | None = None
        self.channel, channel_end = os.pipe()
        self.output, output_end = os.pipe()
        try:
            self.process = subprocess.Popen(
                job.command(channel_end), stdin=subprocess.DEVNULL, stdout=output_end, stderr=output_end,
                pass_fds=(channel_end,), cwd=job.home, env=job.environment, start_new_session=True)
        finally:
            os.close(channel_end)
            os.close(output_end)
        self.deadline = monotonic() + job.limits.wall_s + GRACE_S

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

    def watch_the_clock(self) -> None:
        """Note when the deadline has come."""
        if self.cut is None and not self.complete and monotonic() > self.deadline:
            self.cut = 'wall'

    def end(self) -> None:
        """Kill the child and its process group, then let the system forget it.

        Nothing of it runs afterwards, unless it left its group on purpose (docs/grading.md says so).
        """
        ended_by_itself = self._has_ended()
        try:
            os.killpg(
                self.process.pid, signal.SIGKILL
            )  # before wait(): until then the group's number is surely its own
        except (ProcessLookupError, PermissionError):
            self.process.kill()
        code = self.process.wait()
        self.returncode = code if ended_by_itself else None
        _wait_for_the_group(self.process.pid)
        os.close(self.channel)
        os.close(self.output)

    def _has_ended(self) -> bool:
        """Whether the child has ended; where the system can, without making it forget the child's number."""
        if not hasattr(os, 'waitid'):
            return self.process.poll() is not None
        return os.waitid(os.P_PID, self.process.pid, os.WEXITED | os.WNOHANG | os.WNOWAIT) is not None

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
