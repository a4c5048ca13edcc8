"""What a child process is told, and the surroundings it gets."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from typing import Any

from edulaunch.underlay_place import engine_folder

from .limits import MEBI, Limits
from .readable import readable_by_run
from .scenario import Scenario
from .submission import Submission


class Job:
    """One scenario of one submission, ready to be run.

    :param home: a private folder: the child's current folder, HOME and TMPDIR.
    """

    def __init__(self, submission: Submission, scenario: Scenario, limits: Limits, workspaces: Sequence[str], home: str) -> None:
        self.submission = submission
        self.scenario = scenario
        self.limits = limits
        self.workspaces = [os.path.abspath(path) for path in workspaces]
        self.home = home

    @property
    def message(self) -> dict[str, Any]:
        """What the child is told, as plain data."""
        return {
            'file': self.submission.file,
            'folder': self.submission.folder,
            'arguments': dict(self.scenario.arguments),
            'duration_s': self.scenario.duration_s,
            'seed': self.scenario.seed,
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


def environment(home: str) -> dict[str, str]:
    """A small environment of its own: where programs are, and maths libraries kept to one thread."""
    return {
        'PATH': os.environ.get('PATH', os.defpath),
        'HOME': home,
        'TMPDIR': home,
        'LANG': 'C.UTF-8',
        'USER': 'student',
        'PYTHONHASHSEED': '0',  # the order of a set decides no mark
        'OPENBLAS_NUM_THREADS': '1',
        'OMP_NUM_THREADS': '1',
    }


def import_path() -> list[str]:
    """Where the child finds modules: as this process does, but not in the current folder."""
    engine = os.path.dirname(engine_folder())
    here = os.getcwd()
    known = [path for path in sys.path if path and os.path.abspath(path) != here]
    return known if engine in known else [engine, *known]
