"""The input of a run: its arguments, limits, readable files and environment."""

from __future__ import annotations

import os
import sys
from collections import Counter
from collections.abc import Sequence
from typing import Any, NamedTuple

from .evidence import Outcome, Scenario
from .places import environment
from .sandbox.allowance import MOST_BYTES_OF_FILE
from .submission import Submission

MEBI = 1 << 20
CAN_FORK = hasattr(os, 'fork') and sys.platform != 'emscripten'
"""Whether a run can have its own process. This is not possible on Windows or in a browser, where the function exists but
fails.
"""


class Limits(NamedTuple):
    """The limits of one child process. In practice, students reach only the limit on real time.

    :param wall_s: real seconds for one scenario. The rubric sets the simulated duration.
    :param memory_mib: address space in MiB.
    :param output_mib: size of the output in MiB.
    :param recording_mib: size of the recording in MiB.
    :param sandbox: 'auto' confines runs as far as the system can, 'require' refuses runs that are not fully confined, and
        'off' limits only time and memory.
    :param turn_s: processor time of one turn of a program, in seconds. A single call into C may take two and a half times as
        long. The limit is short, because each endless loop delays a class. Exercises need a hundredth of it.
    """

    wall_s: float = 30.0
    memory_mib: int = 2048
    output_mib: int = 4
    recording_mib: int = 128
    sandbox: str = 'auto'
    turn_s: float = 0.8

    @property
    def resources(self) -> dict[str, int]:
        """The limits for setrlimit, by the name that follows ``RLIMIT_``."""
        return {
            'CPU': int(self.wall_s) + 5,
            'AS': self.memory_mib * MEBI,
            'FSIZE': MOST_BYTES_OF_FILE,
            'NOFILE': 256,
            'CORE': 0,
            'SIGPENDING': 256,
        }


class GradingJob:
    """The runs of one submission, with their scenarios and outcomes."""

    def __init__(self, scenarios: Sequence[Scenario]) -> None:
        self.scenarios = list(scenarios)
        self.outcomes: dict[str, Outcome] = {}
        self.again: Counter[str] = Counter()  # number of repetitions of a run, by the name of its scenario

    @property
    def is_done(self) -> bool:
        """Whether all runs have ended."""
        return len(self.outcomes) == len(self.scenarios)


class RunRequest:
    """One scenario of one submission, with everything that its run needs.

    :param home: a private folder, which is the child's current folder, HOME and TMPDIR.
    """

    def __init__(self, submission: Submission, scenario: Scenario, limits: Limits, workspaces: Sequence[str], home: str) -> None:
        self.submission = submission
        self.scenario = scenario
        self.limits = limits
        self.workspaces = [os.path.abspath(path) for path in workspaces]
        self.home = home

    @property
    def message(self) -> dict[str, Any]:
        """The input of the child as plain data."""
        return {
            'file': self.submission.file,
            'folder': self.submission.folder,
            'arguments': dict(self.scenario.arguments),
            'duration_s': self.scenario.duration_s,
            'seed': self.scenario.seed,
            'is_interrupted': self.scenario.is_interrupted,
            'workspaces': self.workspaces,
            'home': self.home,
            'environment': environment(self.home),
            'wall_s': self.limits.wall_s,
            'turn_s': self.limits.turn_s,
            'limits': self.limits.resources,
            'most_bytes': self.limits.recording_mib * MEBI,
            'tree_memory': self.limits.memory_mib * MEBI,
            'sandbox': self.limits.sandbox,
            'readable': readable_by_run(self.submission, self.workspaces),
        }


def readable_by_run(submission: Submission, workspaces: Sequence[str]) -> list[str]:
    """Return the paths that a run may read in addition: its package and workspaces.

    For a launch file that is not in a package, this is only the file itself, and the workspaces.
    """
    return [submission.package.path if submission.package else submission.file, *workspaces]
