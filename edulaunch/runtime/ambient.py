"""The process that represents code outside any launched program, such as a plain script or a notebook cell.

In a plain script that reads the real clock, the time of ROS is also the real time.
"""

from __future__ import annotations

import datetime
import os
import signal
import sys
import threading
import time
from collections.abc import Callable
from types import FrameType

from edulaunch.engine.graph.graph import Graph
from edulaunch.engine.packages.sourced import sourced_index, sourced_path
from edulaunch.engine.processes.commands import CommandSet
from edulaunch.engine.processes.frame_owner import is_own
from edulaunch.engine.processes.host import Host
from edulaunch.engine.processes.process import Process
from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.engine.sim.real_threads import RealThreads, start_real_thread
from edulaunch.engine.sim.task import AmbientTask, Task, current_task
from edulaunch.runtime.fittings import hint_of
from edulaunch.runtime.shell import SimulatedShell

CLOCKS = frozenset(map(id, (time, datetime, datetime.datetime, *filter(callable, vars(time).values()))))
"""A module with one of these global names reads the real clock, or waits for it."""


def script_sees_the_clock() -> bool:
    """Return whether the script that first uses ROS reads the real clock.

    The result is False in tests and notebooks, whose code is not a script. There, simulated time passes as fast as possible.
    """
    if not _is_script():
        return False
    frame: FrameType | None = sys._getframe(1)
    while frame is not None:
        file = frame.f_code.co_filename
        if is_own(file) and file[0] != '<' and not CLOCKS.isdisjoint(map(id, list(frame.f_globals.values()))):
            return True
        frame = frame.f_back
    return False


def _is_script() -> bool:
    """Return whether Python runs a student's script, and not a notebook, a test or another program."""
    main = getattr(sys.modules.get('__main__'), '__file__', None)
    return main is not None and is_own(main)


class AmbientProcess(Process):
    """The process of a script or notebook cell that uses ROS packages directly. It has the real standard streams."""

    keeps_time = False
    """Whether the script reads the real clock, so simulated time equals real time."""

    def receive_real(self, number: int) -> Callable[[int], object] | None:
        """In the main thread of a script, receive the real signals of this number. Return the script's own handler, or None."""
        if not _is_script() or threading.current_thread() is not threading.main_thread():
            return None
        before = self.state.setdefault('real signals', {})[number] = signal.signal(number, self._receive)
        if before in (signal.SIG_DFL, signal.default_int_handler):
            return None
        return lambda signum: before(signum, None) if callable(before) else None

    def release_real(self, number: int) -> None:
        """Give the real signals of this number back to the handler that received them before."""
        before = self.state.get('real signals', {}).pop(number, None)
        if before is not None and signal.getsignal(number) == self._receive:
            signal.signal(number, before)

    def _receive(self, number: int, _: FrameType | None) -> None:
        self.send_signal(number)

    def has_imported(self, package: str) -> bool:
        """Return whether this interpreter has imported a package. No loader observes the imports of a script."""
        return package in sys.modules

    def write(self, stream: str, text: str) -> None:
        """Write to the real stream of that name."""
        target = sys.stdout if stream == 'stdout' else sys.stderr
        target.write(text + self.host.hints.below(text, self.pid, self.env) if self.host.hints.pending else text)
        target.flush()

    def start_thread(self, body: Callable[[], object], name: str, daemon: bool, *, at_once: bool = False) -> Task:
        """Start a simulated thread of the program. If a real thread calls this method, start a real thread that runs
        independently of the simulation.
        """
        if current_task().is_real_thread:
            return start_real_thread(body, name)
        return super().start_thread(body, name, daemon, at_once=at_once)

    def start_worker(self, body: Callable[[], object], name: str) -> Task:
        """Start a task that runs callbacks. In a script that reads the real clock, start a real thread, because a callback that
        waits in `time.sleep` must not stop the other threads.
        """
        return start_real_thread(body, name) if self.keeps_time else self.start_thread(body, name, True)


def make_ambient_process(task: AmbientTask) -> Process:
    """Create a process around `task`, with its own graph, host and index of sourced packages.

    In a script that reads the real clock, simulated time equals real time.
    """
    task.real_threads = RealThreads(task)
    keeps_time = script_sees_the_clock()
    if keeps_time:
        task.real_threads.keep_time()
    prefixes = [path for path in sourced_path().split(os.pathsep) if path]
    commands = CommandSet(shell=SimulatedShell())
    host = Host(task.sim, Graph(task.sim), sourced_index(prefixes), env=dict(os.environ), command_set=commands, hint_of=hint_of)
    process = ambient_process_on(host, task)
    process.keeps_time = keeps_time
    return process


def ambient_process_on(host: Host, task: AmbientTask) -> AmbientProcess:
    """Create a process around `task` on an existing machine."""
    spec = ProcessSpec(argv=tuple(sys.argv), name='main', env=os.environ)
    process = AmbientProcess(host, spec, host.next_pid(), list(sys.argv), lambda _: None)
    process.lifecycle.task = task
    task.real_threads = task.real_threads or RealThreads(task)
    process.sourced_path = sourced_path()
    process.env = os.environ  # type: ignore[assignment]  # a plain script and its launch files share one environment
    process.streams.stdin = sys.stdin
    process.streams.is_writing = True  # a plain script always uses the real streams
    process.signals.handlers.clear()
    return process
