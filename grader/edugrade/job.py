"""The input of a runner: the arguments, limits, readable files and environment of a run."""

from __future__ import annotations

import os
import sys
from collections import Counter
from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

from edulaunch.engine.underlay_place import engine_folder

from .evidence import Outcome, Scenario
from .rubrics.catalogue import rubrics_folder
from .submission import Submission

MEBI = 1 << 20
CAN_FORK = hasattr(os, 'fork') and sys.platform != 'emscripten'
"""Whether a run can have a process of its own: not on Windows, nor in a browser, where Python has the function and it fails."""


class Limits(NamedTuple):
    """Limits of one child process; wall-clock time is the only one that a student should ever meet.

    :param wall_s: seconds of real time for one scenario. The simulated duration is the rubric's business.
    :param memory_mib: address space.
    :param output_mib: what it may print.
    :param recording_mib: what it may send back.
    :param sandbox: 'auto' confines as far as the system can, 'require' runs nothing that is not confined wholly, 'off' confines
        nothing but time and memory.
    :param turn_s: processor time of one turn of a program. A single call into C may take two and a half times as long.
        Exercises need a hundredth of it, and a class waits for each endless loop.
    """

    wall_s: float = 30.0
    memory_mib: int = 2048
    output_mib: int = 4
    recording_mib: int = 128
    sandbox: str = 'auto'
    turn_s: float = 0.8

    @property
    def resources(self) -> dict[str, int]:
        """For setrlimit, by the name behind ``RLIMIT_``."""
        return {
            'CPU': int(self.wall_s) + 5,
            'AS': self.memory_mib * MEBI,
            'FSIZE': 64 * MEBI,
            'NOFILE': 256,
            'CORE': 0,
            'SIGPENDING': 256,
        }


class GradingJob:
    """The runs of one submission: what is asked for, and what has come of it."""

    def __init__(self, scenarios: Sequence[Scenario]) -> None:
        self.scenarios = list(scenarios)
        self.outcomes: dict[str, Outcome] = {}
        self.again: Counter[str] = Counter()  # how often a run was begun again, by the scenario's name

    @property
    def is_done(self) -> bool:
        """Whether every run has ended."""
        return len(self.outcomes) == len(self.scenarios)


class RunRequest:
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
        """Return the input of the child as plain data."""
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


def environment(home: str) -> dict[str, str]:
    """Return a small environment of its own: where programs are, and maths libraries kept to one thread."""
    return {
        'PATH': os.environ.get('PATH', os.defpath),
        'HOME': home,
        'TMPDIR': home,
        'LANG': 'C.UTF-8',
        'USER': 'student',
        'PYTHONHASHSEED': '0',  # the order of a set must not affect a mark
        'OPENBLAS_NUM_THREADS': '1',
        'OMP_NUM_THREADS': '1',
    }


def import_path() -> list[str]:
    """Where the child finds modules: as this process does, but in folders of Python and with what the engine needs only."""
    engine = os.path.dirname(engine_folder())
    here = os.getcwd()
    known = [path for path in sys.path if path and os.path.abspath(path) != here and (_is_of_python(path) or _needed_in(path))]
    return known if engine in known else [engine, *known]


PACKAGES = ('site-packages', 'dist-packages')
NEEDED = ('greenlet', 'yaml', '_yaml', 'numpy', 'numpy.libs', 'matplotlib', 'rosbags', 'transforms3d', 'urdf_parser_py')
SYSTEM = (
    *('/usr', '/bin', '/sbin', '/lib', '/lib32', '/lib64', '/libx32', '/opt'),
    *('/etc/ld.so.cache', '/etc/ld.so.preload', '/etc/localtime', '/etc/timezone', '/etc/passwd', '/etc/group'),
    *('/etc/nsswitch.conf', '/etc/hosts', '/etc/os-release', '/etc/mime.types', '/etc/fonts', '/etc/alternatives'),
)


def readable_by_all(path: Sequence[str]) -> tuple[list[str], list[str]]:
    """Return (what may be read with all below it, folders that may be listed only), for every run.

    :param path: where Python looks for modules.
    """
    roots, hidden = shown_to_all(path)
    read: dict[str, None] = {}
    listed: dict[str, None] = {}
    seen: set[str] = set()
    for root in roots:
        for place, is_whole in _beneath(os.path.realpath(root), hidden, seen):
            (read if is_whole else listed).setdefault(place)
    for each in path:
        if not _is_of_python(each) and _needed_in(each):
            listed.setdefault(os.path.realpath(each))
    return list(read), list(listed)


def shown_to_all(path: Sequence[str]) -> tuple[list[str], list[str]]:
    """Return (places that every run sees, folders in them that are hidden from it: the grader and the rubrics).

    :param path: where Python looks for modules.
    """
    own = os.path.dirname(os.path.abspath(__file__))
    hidden = [os.path.realpath(each) for each in (own, rubrics_folder())]
    engine = os.path.realpath(engine_folder())
    packages = [place for each in path for place in ([each] if _is_of_python(each) else _needed_in(each))]
    return [sys.prefix, sys.base_prefix, engine, *SYSTEM, *packages], hidden


def readable_by_run(submission: Submission, workspaces: Sequence[str]) -> list[str]:
    """Return what else the run may read: its package and workspaces. A launch file alone may read only itself."""
    return [submission.package.path if submission.package else submission.file, *workspaces]


def _is_of_python(path: str) -> bool:
    """Whether it is Python's own, or a folder of installed packages: what PYTHONPATH or pytest add may hold people's files."""
    roots = [os.path.join(os.path.realpath(root), 'lib', '') for root in (sys.prefix, sys.base_prefix)]
    real = os.path.realpath(path)
    return os.path.basename(real) in PACKAGES or any(f'{real}{os.sep}'.startswith(root) for root in roots)


def _needed_in(path: str) -> list[str]:
    """Of another folder what the engine needs of it."""
    return [place for place in (os.path.join(path, name) for name in NEEDED) if os.path.exists(place)]


def _beneath(place: str, hidden: Sequence[str], seen: set[str]) -> Iterator[tuple[str, bool]]:
    """(place, whether with all below it) so that everything in `place` can be read but what is hidden. Links are resolved."""
    if place in seen or any(place == each or place.startswith(os.path.join(each, '')) for each in hidden):
        return
    seen.add(place)
    if not any(each.startswith(os.path.join(place, '')) for each in hidden):
        yield place, True
        return
    yield place, False
    for name in sorted(os.listdir(place)):
        yield from _beneath(os.path.realpath(os.path.join(place, name)), hidden, seen)
