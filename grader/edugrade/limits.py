"""What one run of a submission may use."""

from __future__ import annotations

import os
import sys

MEBI = 1 << 20
CAN_FORK = hasattr(os, 'fork') and sys.platform != 'emscripten'
"""Whether a run can have a process of its own: not on Windows, nor in a browser, where Python has the function and it fails."""


class Limits:
    """Limits of one child process; wall-clock time is the only one that a student should ever meet.

    :param wall_s: seconds of real time for one scenario. The simulated duration is the rubric's business.
    :param memory_mib: address space.
    :param output_mib: what it may print.
    :param recording_mib: what it may send back.
    :param sandbox: 'auto' confines as far as the system can, 'require' runs nothing that is not confined wholly, 'off' confines
        nothing but time and memory.
    :param turn_s: processor time that one turn of a program may take (exercises need a hundredth of it, and a class waits for
        each endless loop), a single call into C two and a half times that.
    """

    def __init__(
        self,
        wall_s: float = 30.0,
        memory_mib: int = 2048,
        output_mib: int = 4,
        recording_mib: int = 128,
        sandbox: str = 'auto',
        turn_s: float = 0.8,
    ) -> None:
        self.wall_s = wall_s
        self.memory_mib = memory_mib
        self.output_mib = output_mib
        self.recording_mib = recording_mib
        self.sandbox = sandbox
        self.turn_s = turn_s

    @property
    def resources(self) -> dict[str, int]:
        """For setrlimit, by the name behind ``RLIMIT_``."""
        return {'CPU': int(self.wall_s) + 5, 'AS': self.memory_mib * MEBI, 'FSIZE': 64 * MEBI, 'NOFILE': 256, 'CORE': 0}
