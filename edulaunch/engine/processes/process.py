"""A launched program in the simulation: its own pid, arguments, environment, streams, modules and end."""

from __future__ import annotations

import os
from collections.abc import Callable, Hashable
from threading import get_ident
from typing import TYPE_CHECKING, Any

from edulaunch.engine.processes.spec import ProcessSpec, Signals
from edulaunch.engine.processes.streams import MARK, Addresses, OutputStream
from edulaunch.engine.processes.watchdog import RunawayProgram
from edulaunch.engine.sim.task import Task, TaskKilled, running_task

if TYPE_CHECKING:
    from edulaunch.engine.packages import Index
    from edulaunch.engine.processes.finding import Overlay
    from edulaunch.engine.processes.host_face import HostFace, OnExit, OnOutput
    from edulaunch.engine.processes.loader import Loader
    from edulaunch.engine.processes.spec import Origin

MOST_WRITES = 10_000
MOST_TEXT = 4_000_000
"""How many times, and how many characters, a program may write while no simulated time passes; and for each that it started."""
DEADLY = (Signals.SIGKILL, Signals.SIGTERM, Signals.SIGQUIT, Signals.SIGHUP, Signals.SIGALRM, Signals.SIGUSR1, Signals.SIGUSR2)
"""What ends a program that has no handler for it."""
LAST_WORDS = (Signals.SIGTERM, Signals.SIGKILL)
"""What comes when a program does not end by itself."""


class Process:
    """One simulated program. `state` is a dict in which the ROS faces keep what would be process-wide globals.

    Attributes: `spec`, `pid`, `argv` (as the program sees it), `env` (a dict of its own), `sourced_path` (AMENT_PREFIX_PATH
    as sourcing left it), `cwd` (None: that of the launcher), `returncode` (None while it runs; negative for a signal, as in
    `subprocess`), `sim`, `graph`, `index`, `host`, `tracer`, `stdin`, `stdout`, `stderr`, `exception` (what ended it: type,
    message, place), `used` (what it used of the real machine), `is_writing` (while its output is handed on), `speaks_for` (of how
    many programs it may have to write the output), `is_gone` (dead, yet its stack unwinds), `is_heard` (its output is recorded;
    that of a child is, as far as it reaches the program that started it), `loader`,
    `group` (the program that a terminal started, whose Ctrl-C reaches this one), `is_passed_on` (the program that started this
    one hands it the Ctrl-C that it gets), `on_sleep` (told of each `time.sleep`).
    """

    def __init__(self, host: HostFace, spec: ProcessSpec, pid: int, argv: list[str], main: Callable[[Process], object]) -> None:
        parent = host.program_here()
        self.host = host
        self.sim = host.sim
        self.graph = host.graph
        self.index: Index = host.index if parent is None else parent.index
        self.group: Process = self if parent is None else parent.group
        self.is_passed_on = False
        self.tracer = host.tracer
        self.spec = spec
        self.pid = pid
        self.argv = argv
        self.env: dict[str, str] = dict(spec.env if spec.env is not None else host.env)
        self.sourced_path = host.env.get('AMENT_PREFIX_PATH', '')
        self.state: dict[str, Any] = {}
        self.exception: dict[str, Any] | None = None
        self.used: set[str] = set()
        self.returncode: int | None = None
        self.on_output: OnOutput | None = None
        self.on_exit: OnExit | None = None
        self.signal_handlers: dict[int, Callable[[int], object]] = {}
        self.at_exit: list[Callable[[], object]] = []
        self.on_sleep: Callable[[float], object] | None = None
        self.before_join: list[Callable[[], object]] = []
        self.exit_calls: list[tuple[Callable[..., object], tuple[Any, ...], dict[str, Any]]] = []
        self.cwd = spec.cwd
        self.threads: list[Task] = []
        self.stdin: Any = host.stdin_for(spec)
        self.stdout = OutputStream(self.write, 'stdout')
        self.stderr = OutputStream(self.write, 'stderr')
        self.is_writing = False
        self.speaks_for = 1
        self._wrote_at_ns, self._writes, self._wrote = 0, 0, 0
        self.is_gone = False
        self.is_heard = True
        self.addresses = Addresses()
        self._main = main
        self._loader: Loader | None = None
        self._signal: int | None = None
        self.task = Task(host.sim, self._run, name=spec.name, owner=self)
        self.task.add_done_callback(self._end_unbegun)

    def __repr__(self) -> str:
        return f'<process {self.spec.name} [{self.pid}]>'

    @property
    def name(self) -> str:
        """The launch name, such as 'talker-1'."""
        return self.spec.name

    @property
    def loader(self) -> Loader:
        """The private modules of this program."""
        if self._loader is None:
            from edulaunch.engine.processes.loader import Loader

            self._loader = Loader(self, self.host.compiled)
        return self._loader

    @property
    def overlay(self) -> Overlay:
        """Modules and interfaces of the student's workspaces."""
        return self.host.overlay(self.index)

    def path(self, path: str) -> str:
        """A path as the program means it: a relative one begins in the folder where the program runs."""
        return path if self.cwd is None else os.path.join(self.cwd, path) if path else self.cwd

    def write(self, stream: str, text: str) -> None:
        """Write to 'stdout' or 'stderr', as the program itself does; recorded, and told to whoever started it.

        :raises RunawayProgram: inside a program that writes on and on without letting time pass.
        """
        if self.is_gone:
            return
        self._count(text)
        before, self.is_writing = self.is_writing, True
        try:
            text = self.steady(text)
            if self.is_heard:
                self.tracer.output(self, stream, text)
            if self.on_output is not None:
                self.on_output(stream, text)
                if self.host.hints.pending and self.on_output is self.group.on_output:
                    self._show_hint_below(stream, text)
        finally:
            self.is_writing = before

    def _show_hint_below(self, stream: str, text: str) -> None:
        """The hint for an error that has just come to the console; not recorded."""
        hint = self.host.hints.below(text, self.group.pid, self.group.env)
        if hint and self.on_output is not None:
            self.on_output(stream, hint)

    def _count(self, text: str) -> None:
        """A loop that writes and never waits would fill the memory, and others would have to read all of it, long before the
        watchdog sees it.
        """
        if self._wrote_at_ns != self.sim.now_ns:
            self._wrote_at_ns, self._writes, self._wrote = self.sim.now_ns, 0, 0
        self._writes += 1
        self._wrote += len(text)
        too_much = self._writes > MOST_WRITES * self.speaks_for or self._wrote > MOST_TEXT * self.speaks_for
        if too_much and self.returncode is None:
            task = running_task()
            if task is not None and task.owner is self:
                raise RunawayProgram(f'wrote {self._writes - 1} times in one instant', counted=True)

    def steady(self, text: str) -> str:
        """A text of the program without what would differ from run to run: addresses of objects."""
        return self.addresses.steady(text) if MARK in text else text

    def log(self, level: int, logger: str, message: str) -> None:
        """Record a log message (its console line is written separately)."""
        if self.is_gone:
            return
        self.tracer.log(self, level, logger, message)

    def note(self, kind: str, text: str) -> None:
        """Record something that the engine noticed and the user should hear about."""
        if self.is_gone:
            return
        self.tracer.note(self, kind, text)

    def fact(self, kind: str, key: Hashable, data: dict[str, Any]) -> None:
        """Record something odd in plain data, without words (`edulaunch.advice` has those); counted when the key came before.

        File and line of the student's code stand in it as `file` and `line`; times are seconds since the start.
        """
        if not self.is_gone:
            self.tracer.fact(self, kind, key, data)

    def fact_over(self, kind: str, key: Hashable) -> None:
        """Take such a fact back: what looked odd has come right."""
        if not self.is_gone:
            self.tracer.fact_over(self, kind, key)

    def start_thread(self, body: Callable[[], object], name: str, daemon: bool, *, at_once: bool = False) -> Task:
        """A further task of this program. The program does not end before its threads do, unless they are daemons.

        :param at_once: let it run up to where it first waits, before this returns.
        """
        task = Task(self.sim, lambda: self._run_thread(body), name=name, owner=self)
        if not daemon:
            self.threads.append(task)
        else:
            self.at_exit.append(task.kill)
        if at_once:
            task.start_at_once()
        else:
            task.start()
        return task

    def _run_thread(self, body: Callable[[], object]) -> object:
        try:
            return body()
        except RunawayProgram as error:
            self._print_runaway(error)
            self.returncode = 1
            self.task.kill()
            return None

    def send_signal(self, signum: int) -> None:
        """Deliver a signal. A handler in `signal_handlers` decides; else SIGINT raises KeyboardInterrupt in the program where
        it waits, those of DEADLY end it, and any other is ignored. Nothing happens after the end. A program that sends a signal
        to itself takes it before this returns.
        """
        signum = int(signum)
        if self.returncode is not None:
            return
        if signum in LAST_WORDS:
            self._note_waits(signum)
        handler = self.signal_handlers.get(signum)
        if handler is not None and signum != Signals.SIGKILL:
            self.task.interrupt(lambda: handler(signum))
        elif signum == Signals.SIGINT:
            self.task.interrupt(_raise_keyboard_interrupt)
        elif signum in DEADLY:
            self.die_of(signum)
        if running_task() is self.task:
            self.task.attend()

    def _note_waits(self, signum: int) -> None:
        """SIGTERM or SIGKILL: it did not heed Ctrl-C. Where each of its threads stands, main first."""
        from edulaunch.engine.processes.frame_owner import waiting_line

        waits = [{'thread': task.name, **waiting_line(task)} for task in (self.task, *self.threads) if not task.finished]
        self.fact('ended by force', signum, {'signal': signum, 'waits': waits})

    def die_of(self, signum: int) -> None:
        """End by a signal without a handler: Python has no time for `finally` blocks then."""
        self._signal = signum
        self._vanish()

    def die_at_once(self, signum: int) -> None:
        """The handler that stands for the default action of a signal; called inside the program."""
        self.die_of(signum)
        self.task.attend()

    def _vanish(self) -> None:
        """Kill the program. Unwinding its stack runs its `finally` blocks, which a real end does not: nobody hears of them."""
        self.is_gone = True
        self.graph.remove_process(self)
        self.task.kill()

    def exit_now(self, code: int) -> None:
        """End at once without cleaning up, as `os._exit`."""
        self.returncode = code
        self._vanish()
        self.task.park()

    def end_by(self, signum: int) -> None:
        """End at once as if by a signal that nothing can handle."""
        self.exit_now(-signum)

    def _run(self) -> None:
        code: int | None = None
        if self.host.watchdog is not None:
            self.host.watchdog.thread = get_ident()
        try:
            code = self._main_exit_code()
            self._join_threads()
            self.run_exit_calls()
        finally:
            if self.returncode is None:
                killed = code is None or self._signal is not None
                self.returncode = -(self._signal or Signals.SIGKILL) if killed else code
            self._end()

    def _end_unbegun(self, task: Task) -> None:
        """A signal that comes before the first turn ends the program, too."""
        if self.returncode is None:
            interrupted = isinstance(task.exception, KeyboardInterrupt)
            self.returncode = -(Signals.SIGINT if interrupted else self._signal or Signals.SIGKILL)
            self._end()

    def _main_exit_code(self) -> int:
        try:
            return exit_code(self, self._main(self))
        except SystemExit as end:
            return exit_code(self, end.code)
        except KeyboardInterrupt as error:
            self._print_traceback(error)
            return -Signals.SIGINT
        except RunawayProgram as error:
            self._print_runaway(error)
            return 1
        except TaskKilled:
            raise
        except BaseException as error:
            self._print_traceback(error)
            return 1

    def _print_traceback(self, error: BaseException) -> None:
        from edulaunch.engine.processes.error_facts import error_facts
        from edulaunch.engine.processes.traceback_text import student_traceback

        view = self.loader.modules.get('sys')
        if view is not None and 'excepthook' in view.__dict__:
            view.excepthook(type(error), error, error.__traceback__)
            return
        text, place = student_traceback(error)
        self._write_error(text, type(error).__name__, str(error).partition('\n  help: ')[0], place, error_facts(self, error))

    def _write_error(self, text: str, kind: str, message: str, place: Origin | None, facts: dict[str, Any]) -> None:
        """Write what ended the program, and keep it as data."""
        self.exception = {'type': kind, 'message': message, 'place': place, 'facts': facts}
        self.host.hints.expect(text, {**self.exception, 'process': self.name}, self.group.pid)
        self.write('stderr', text)

    def _print_runaway(self, error: RunawayProgram) -> None:
        from edulaunch.engine.processes.traceback_text import runaway_text

        text, place = runaway_text(self.name, error)
        self._wrote_at_ns = 0
        if not error.counted:
            self.note('stopped', f'{self.name} was stopped by the time that it took: this run cannot repeat exactly')
        self._write_error(text, 'RunawayProgramError', str(error), place, {'about': 'programs.runaway'})

    def run_exit_calls(self) -> None:
        """Call what the program registered with `atexit`, the last one first."""
        while self.exit_calls:
            function, arguments, options = self.exit_calls.pop()
            try:
                function(*arguments, **options)
            except Exception as error:
                from edulaunch.engine.processes.traceback_text import student_traceback

                self.write('stderr', f'Exception ignored in atexit callback:\n{student_traceback(error)[0]}')

    def _join_threads(self) -> None:
        for action in reversed(self.before_join):
            action()
        for thread in self.threads:
            while not thread.finished:
                thread.add_done_callback(lambda _: self.task.wake())
                self.task.park()

    def _end(self) -> None:
        for action in self.at_exit:
            action()
        self.is_gone = True
        for thread in self.threads:
            if not thread.finished:
                thread.kill()
        self.graph.remove_process(self)
        self.host.ended(self)
        if self.on_exit is not None:
            assert self.returncode is not None
            self.on_exit(self.returncode)


def exit_code(process: Process, value: object) -> int:
    """The exit status that `sys.exit(value)` gives: None is 0, a number itself, anything else is printed and 1."""
    if value is None:
        return 0
    if isinstance(value, int):
        return value & 0xFF
    process.write('stderr', f'{value}\n')
    return 1


def _raise_keyboard_interrupt() -> None:
    raise KeyboardInterrupt
