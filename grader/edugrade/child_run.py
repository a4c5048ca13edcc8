"""One child process as the runner sees it: start it, collect what it sends, end it with everything it started."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from collections.abc import Sequence
from select import select
from time import monotonic

from .limits import MEBI, Limits
from .scenario import Scenario
from .submission import Submission

LETTERS = b'RUSB'  # of frames; child.py says what they mean
HEADER_BYTES = 9
CHUNK_BYTES = 1 << 18
KEPT_OUTPUT_BYTES = 1 << 16
GRACE_S = 1.0  # what a child has to answer for itself after its own alarm, or to end after it has let go of the channel


class ChildRun:
    """A scenario on its way. `channel` and `output` are read ends of pipes; `finished` says that nothing more will come."""

    def __init__(
        self, submission: Submission, scenario: Scenario, limits: Limits, workspaces: Sequence[str], home: str
    ) -> None:
        self.scenario = scenario
        self.limits = limits
        self.frame = bytearray()
        self.printed = bytearray()
        self.printed_bytes = 0
        self.cut: str | None = None  # 'wall', 'printed', 'recording' or 'garbage': what ended it
        self.let_go = False  # whether the child closed its end of the channel
        self.returncode: int | None = None
        self.channel, channel_end = os.pipe()
        self.output, output_end = os.pipe()
        job = _job(submission, scenario, limits, workspaces, channel_end)
        try:
            self.process = subprocess.Popen(
                [sys.executable, '-I', '-S', _CHILD, json.dumps(job)],
                stdin=subprocess.DEVNULL,
                stdout=output_end,
                stderr=output_end,
                pass_fds=(channel_end,),
                cwd=home,
                env=_environment(home),
                start_new_session=True,
            )
        finally:
            os.close(channel_end)
            os.close(output_end)
        self.deadline = monotonic() + limits.wall_s + GRACE_S

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
        """Kill the child and its process group, then let the system forget it. Nothing of it runs afterwards, unless it
        left its group on purpose (docs/grading.md says so).
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
        os.close(self.channel)
        os.close(self.output)

    def _has_ended(self) -> bool:
        """Whether the child has ended; where the system can, without making it forget the child's number."""
        if not hasattr(os, 'waitid'):
            return self.process.poll() is not None
        return os.waitid(os.P_PID, self.process.pid, os.WEXITED | os.WNOHANG | os.WNOWAIT) is not None

    def _more_to_read(self) -> bool:
        return not self.let_go and bool(select([self.channel], [], [], 0)[0])


_CHILD = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'child.py')


def _job(
    submission: Submission, scenario: Scenario, limits: Limits, workspaces: Sequence[str], channel: int
) -> dict[str, object]:
    return {
        'channel': channel,
        'path': _import_path(),
        'file': submission.file,
        'folder': submission.folder,
        'arguments': dict(scenario.arguments),
        'duration_s': scenario.duration_s,
        'seed': scenario.seed,
        'workspaces': [os.path.abspath(path) for path in workspaces],
        'wall_s': limits.wall_s,
        'limits': limits.resources,
    }


def _import_path() -> list[str]:
    """Where the child finds modules: as this process does, but never in the folder that edugrade was called from."""
    import edulaunch

    engine = os.path.dirname(os.path.dirname(os.path.abspath(edulaunch.__file__)))
    here = os.getcwd()
    known = [path for path in sys.path if path and os.path.abspath(path) != here]
    return known if engine in known else [engine, *known]


def _environment(home: str) -> dict[str, str]:
    """A small environment of its own: nothing of the caller's but where programs are, and no maths library with many threads."""
    return {
        'PATH': os.environ.get('PATH', os.defpath),
        'HOME': home,
        'TMPDIR': home,
        'LANG': 'C.UTF-8',
        'USER': 'student',
        'OPENBLAS_NUM_THREADS': '1',
        'OMP_NUM_THREADS': '1',
    }
