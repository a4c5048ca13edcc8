"""A launched program in the simulation. A process consists of four parts: `lifecycle`, `streams`, `signals` and `limit`."""

from __future__ import annotations

import os
from collections.abc import Callable, Hashable
from threading import get_ident
from typing import TYPE_CHECKING, Any

from edulaunch.engine.processes.lifecycle import Lifecycle
from edulaunch.engine.processes.limits import WriteLimit
from edulaunch.engine.processes.real_machine import Environment
from edulaunch.engine.processes.signals import SignalDelivery
from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.engine.processes.streams import Streams
from edulaunch.engine.processes.watchdog import BlockedProgram, RunawayProgram
from edulaunch.engine.sim.task import Task, running_task

if TYPE_CHECKING:
    from edulaunch.engine.packages import Index
    from edulaunch.engine.processes.finding import Overlay
    from edulaunch.engine.processes.host_face import HostFace, OnExit, OnOutput
    from edulaunch.engine.processes.loader import Loader
    from edulaunch.engine.processes.spec import Origin


class Process:
    """One simulated program.

    :param host: the machine on which the program runs.
    :param spec: the description from which the program was started.
    :param pid: the process number.
    :param argv: the command line as the program itself gets it.
    :param main: the main function of the program, called with this process.
    :ivar sim: the simulation of the machine.
    :ivar graph: the graph of the machine.
    :ivar tracer: the tracer of the machine.
    :ivar index: the packages that the program finds. It inherits them from its parent or, without a parent, from the
        machine.
    :ivar env: the program's own copy of the environment.
    :ivar sourced_path: AMENT_PREFIX_PATH as sourcing has set it.
    :ivar cwd: the working folder, or None for the launcher's working folder.
    :ivar state: the values that ROS packages would store in process-wide globals.
    :ivar exception: the error that ended the program (type, message, place and facts), or None.
    :ivar used: the parts of the real machine that the program has used.
    :ivar parent: the program that started this one, or None.
    :ivar is_recorded: whether the output of the program is recorded. A child's output is recorded only when its parent writes it.
    :ivar group: the program that was started in a terminal, and whose Ctrl-C reaches this program.
    :ivar is_passed_on: whether the parent passes its own Ctrl-C on to this program.
    :ivar on_output: called with the name of the stream and the string for each output, or None.
    :ivar on_exit: called with the return code, or None.
    :ivar on_sleep: called with the seconds of each `time.sleep`, or None.
    """

    def __init__(self, host: HostFace, spec: ProcessSpec, pid: int, argv: list[str], main: Callable[[Process], object]) -> None:
        self.parent = parent = host.program_here()
        self.host = host
        self.sim = host.sim
        self.graph = host.graph
        self.tracer = host.tracer
        self.index: Index = host.index if parent is None else parent.index
        self.group: Process = self if parent is None else parent.group
        self.is_passed_on = False
        self.spec = spec
        self.pid = pid
        self.argv = argv
        self.env: dict[str, str] = Environment(self, spec.env if spec.env is not None else host.env)
        self.sourced_path = host.env.get('AMENT_PREFIX_PATH', '')
        self.cwd = spec.cwd
        self.state: dict[str, Any] = {}
        self.exception: dict[str, Any] | None = None
        self.used: set[str] = set()
        self.is_recorded = True
        self.on_output: OnOutput | None = None
        self.on_exit: OnExit | None = None
        self.on_sleep: Callable[[float], object] | None = None
        self._main = main
        self._loader: Loader | None = None
        self.streams = Streams(host.stdin_for(spec), self.write)
        self.limit = WriteLimit(host.sim)
        self.lifecycle = Lifecycle(self, self._run_main)
        self.signals = SignalDelivery(self.lifecycle, self._note_force)

    def __repr__(self) -> str:
        return f'<process {self.spec.name} [{self.pid}]>'

    @property
    def name(self) -> str:
        """The launch name, such as 'talker-1'."""
        return self.spec.name

    @property
    def returncode(self) -> int | None:
        """The return code; None while the program runs, and negative for a signal, as in `subprocess`."""
        return self.lifecycle.returncode

    @property
    def loader(self) -> Loader:
        """The loader of this program's private modules."""
        if self._loader is None:
            from edulaunch.engine.processes.loader import Loader

            self._loader = Loader(self, self.host.compiled, self.host.lines_in_set_order)
        return self._loader

    def has_imported(self, package: str) -> bool:
        """Return whether this program has imported a package that all programs share. Imports of other programs are ignored."""
        return package in self.loader.shared

    @property
    def overlay(self) -> Overlay:
        """The modules and interfaces of the student's workspaces."""
        return self.host.overlay(self.index)

    def path(self, path: str) -> str:
        """Return a path for the real file system. A relative path of the program starts in the program's working folder."""
        return path if self.cwd is None else os.path.join(self.cwd, path) if path else self.cwd

    def start_thread(self, body: Callable[[], object], name: str, daemon: bool, *, at_once: bool = False) -> Task:
        """Start another task of the program; see :meth:`Lifecycle.start_thread`."""
        return self.lifecycle.start_thread(body, name, daemon, at_once=at_once)

    def start_worker(self, body: Callable[[], object], name: str) -> Task:
        """Start a task that runs callbacks of the program, which may block it."""
        return self.start_thread(body, name, True)

    def send_signal(self, signum: int) -> None:
        """Send a signal to the program; see :meth:`SignalDelivery.deliver`."""
        self.signals.deliver(signum)

    def receive_real(self, number: int) -> Callable[[int], object] | None:
        """Receive the real signals of this number, if the program is a plain script; see `AmbientProcess`."""
        return None

    def release_real(self, number: int) -> None:
        """End :meth:`receive_real` for this number."""

    def _note_force(self, signum: int, waits: list[dict[str, Any]]) -> None:
        self.fact('ended by force', signum, {'signal': signum, 'waits': waits})

    def _run_main(self) -> object:
        if self.host.watchdog is not None:
            self.host.watchdog.thread = get_ident()
        return self._main(self)

    def write(self, stream: str, text: str) -> None:
        """Write to 'stdout' or 'stderr' of the program: record the string, and pass it to `on_output`.

        :raises RunawayProgram: inside a program that writes too much at one instant of simulated time.
        """
        if self.lifecycle.is_dead:
            return
        if self.limit.is_exceeded_by(text) and self.returncode is None:
            task = running_task()
            if task is not None and task.owner is self:
                raise RunawayProgram(f'wrote {self.limit.writes - 1} times in one instant', counted=True)
        before, self.streams.is_writing = self.streams.is_writing, True
        try:
            text = self.streams.steady(text)
            if self.is_recorded:
                self.tracer.output(self, stream, text)
            if self.on_output is not None:
                self.on_output(stream, text)
                if self.host.hints.pending and self.on_output is self.group.on_output:
                    self._show_hint_below(stream, text)
        finally:
            self.streams.is_writing = before

    def _show_hint_below(self, stream: str, text: str) -> None:
        """Write the hint for an error that has just appeared on the console. The hint is not recorded."""
        hint = self.host.hints.below(text, self.group.pid, self.group.env)
        if hint and self.on_output is not None:
            self.on_output(stream, hint)

    def log(self, level: int, logger: str, message: str) -> None:
        """Record a log message. The caller writes the console line separately."""
        if not self.lifecycle.is_dead:
            self.tracer.log(self, level, logger, message)

    def note(self, kind: str, text: str) -> None:
        """Record a message of the engine to the user."""
        if not self.lifecycle.is_dead:
            self.tracer.note(self, kind, text)

    def fact(self, kind: str, key: Hashable, data: dict[str, Any]) -> None:
        """Record an unusual fact as plain data, without sentences (see `edulaunch.advice`). A repeated key increases a count.

        `data` contains the file and the line of the student's code as `file` and `line`. Times are seconds since the start.
        """
        if not self.lifecycle.is_dead:
            self.tracer.fact(self, kind, key, data)

    def fact_over(self, kind: str, key: Hashable) -> None:
        """Withdraw the fact with this key, because the unusual state is over."""
        if not self.lifecycle.is_dead:
            self.tracer.fact_over(self, kind, key)

    def report_error(self, error: BaseException) -> None:
        """Write the traceback of an error that ended the program. If the program has its own `sys.excepthook`, call this
        function instead.
        """
        from edulaunch.engine.processes.error_facts import error_facts
        from edulaunch.engine.processes.traceback_text import student_traceback

        view = self.loader.modules.get('sys')
        if view is not None and 'excepthook' in view.__dict__:
            view.excepthook(type(error), error, error.__traceback__)
            return
        text, place = student_traceback(error)
        self._write_error(text, type(error).__name__, str(error).partition('\n  help: ')[0], place, error_facts(self, error))

    def report_runaway(self, error: RunawayProgram) -> None:
        """Write that the program was stopped because it ran or waited for too long."""
        from edulaunch.engine.processes.traceback_text import runaway_text

        text, place = runaway_text(self.name, error)
        self.limit.reset()
        if not error.counted:
            self.note('stopped', f'{self.name} was stopped because it took too long: this run cannot repeat exactly')
        facts = {'about': 'programs.runaway', 'blocked': self.name if isinstance(error, BlockedProgram) else None}
        self._write_error(text, 'RunawayProgramError', str(error), place, facts)

    def report_exit_call(self, error: Exception) -> None:
        """Write an error of a function that was registered with `atexit`, as Python does."""
        from edulaunch.engine.processes.traceback_text import student_traceback

        self.write('stderr', f'Exception ignored in atexit callback:\n{student_traceback(error)[0]}')

    def _write_error(self, text: str, kind: str, message: str, place: Origin | None, facts: dict[str, Any]) -> None:
        """Write the error that ended the program, and store it as data."""
        self.exception = {'type': kind, 'message': message, 'place': place, 'facts': facts}
        self.host.hints.expect(text, {**self.exception, 'process': self.name}, self.group.pid)
        self.write('stderr', text)

    def leave_graph(self) -> None:
        """Remove the program's nodes from the graph."""
        self.graph.remove_process(self)

    def report_end(self) -> None:
        """Report the end of the program to the machine, and the return code to `on_exit`."""
        self.host.ended(self)
        if self.on_exit is not None:
            assert self.returncode is not None
            self.on_exit(self.returncode)
