"""The parts of the engine that edulaunch's programs need in a real process: real time, real threads, and the process itself.

The parts are registered under the names of the engine's modules; the engine itself is not loaded.
"""

from __future__ import annotations

import os
import random
import signal
import sys
import threading
import time
from functools import cached_property
from importlib import import_module
from select import select
from types import ModuleType
from typing import TYPE_CHECKING, Any, NoReturn

from edulaunch.engine.underlay_place import engine_folder

if TYPE_CHECKING:
    from edulaunch.engine.packages import Index

DISCOVERY_S, SETTLED_S, LONGEST_DISCOVERY_S = 3.5, 1.0, 15.0
"""The limits of discovery. A program that misses the first announcements of a node receives the next one after 3 s."""


class SystemTime:
    """Real time in place of simulated time."""

    def __init__(self) -> None:
        self.start_ns = time.time_ns()

    @property
    def now_ns(self) -> int:
        """Return the real time, in ns since 1970."""
        return time.time_ns()

    def random(self, name: str) -> random.Random:
        """Return a random generator. Unlike in a simulation, its numbers differ in each run."""
        return random.Random()


class RealTask:
    """This thread in place of a task."""

    def __init__(self, sim: SystemTime, owner: ThisProcess) -> None:
        self.sim = sim
        self.owner = owner

    def sleep_until(self, at_ns: int) -> None:
        """Sleep until a time of :class:`SystemTime`."""
        time.sleep(max(0, at_ns - time.time_ns()) / 1e9)

    def poll(self) -> None:
        """Wait a moment, so that a program that reads the clock in a loop does not block the computer."""


class _Loader:
    """The loader of this process, whose modules are Python's own."""

    modules = sys.modules

    def import_(self, name: str) -> ModuleType:
        return import_module(name)


class RealHost:
    """This computer in place of a machine."""

    is_real = True

    def where_on_network(self) -> str:
        """Return the network of the host's programs, and the library that connects to it."""
        from rclpy import get_rmw_implementation_identifier

        domain = os.environ.get('ROS_DOMAIN_ID') or '0'
        return f'domain {domain}, by {get_rmw_implementation_identifier()}'

    def discover(self, node: Any) -> None:
        """Wait until discovery is complete: at least `DISCOVERY_S`, and until no new information has arrived for `SETTLED_S`.

        A busy computer replies late.
        """
        began_s = changed_s = time.monotonic()
        known: object = None
        while (now_s := time.monotonic()) < began_s + LONGEST_DISCOVERY_S and node.context.ok():
            found = sorted(node.get_node_names_and_namespaces()), sorted(node.get_topic_names_and_types())
            if found != known:
                known, changed_s = found, now_s
            elif now_s > max(began_s + DISCOVERY_S, changed_s + SETTLED_S):
                break
            time.sleep(0.05)


class RealStreams:
    """The standard streams of this process."""

    @property
    def stdin(self) -> Any:
        """Return standard input."""
        stdin: Any = sys.stdin
        stdin.is_ready = lambda: bool(select([stdin], (), (), 0)[0])
        return stdin

    @property
    def stdout(self) -> Any:
        """Return standard output."""
        return sys.stdout

    @property
    def stderr(self) -> Any:
        """Return standard error."""
        return sys.stderr


class RealLifecycle:
    """The lifecycle of this process. It can only end the process."""

    def exit_now(self, code: int) -> NoReturn:
        """End the process immediately, with an exit code, or with the signal that a negative code names."""
        if code < 0:
            signal.signal(-code, signal.SIG_DFL)
            os.kill(os.getpid(), -code)
        os._exit(code)


class ThisProcess:
    """This real process in place of a simulated process. It collects no facts for advice."""

    def __init__(self, name: str) -> None:
        self.name = name
        self.host = RealHost()
        self.sim = SystemTime()
        self.state: dict[str, Any] = {}
        self.loader = _Loader()
        self.streams = RealStreams()
        self.lifecycle = RealLifecycle()
        self.env = os.environ
        self.returncode = None
        self.pid = os.getpid()
        self.cwd = os.getcwd()
        self.sourced_path = os.environ.get('AMENT_PREFIX_PATH', '')

    @property
    def argv(self) -> list[str]:
        """Return the command line of the process."""
        return sys.argv

    @cached_property
    def index(self) -> Index:
        """Return the index of the packages that the process finds."""
        from edulaunch.engine.packages import Index

        return Index([path for path in self.sourced_path.split(os.pathsep) if path])

    def write(self, stream: str, text: str) -> None:
        """Write to 'stdout' or 'stderr'."""
        getattr(sys, stream).write(text)
        getattr(sys, stream).flush()

    def has_imported(self, package: str) -> bool:
        """Return whether the program has imported a package. No other program shares this process."""
        return package in sys.modules

    def fact(self, kind: str, key: object, data: object) -> None:
        """Do nothing, because a real process stores no facts."""

    def fact_over(self, kind: str, key: object) -> None:
        """Do nothing, because a real process stores no facts."""


def install(name: str) -> ThisProcess:
    """Replace the modules of the engine in this process."""
    process = ThisProcess(name)
    task = RealTask(process.sim, process)
    _module('edulaunch.engine.sim.task', current_task=lambda: task, running_task=lambda: task)
    _module('edulaunch.engine.sim.sync', sleep=time.sleep, Lock=threading.Lock)
    _module('edulaunch.engine.processes.current', current_process=lambda: process)
    _module('edulaunch.engine.processes.frame_owner', student_line=dict)
    _module('edulaunch.engine.processes', current_process=lambda: process).__path__ = [_folder('processes')]
    return process


def _folder(room: str) -> str:
    return os.path.join(engine_folder(), 'engine', room)


def _module(name: str, **values: object) -> ModuleType:
    module = sys.modules[name] = ModuleType(name)
    module.__dict__.update(values)
    return module
