"""The lifecycle of a program: its main task, its threads, the functions to call at its end, and its return code."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Protocol

from edulaunch.engine.processes.spec import Signals
from edulaunch.engine.processes.watchdog import RunawayProgram
from edulaunch.engine.sim.simulation import Simulation
from edulaunch.engine.sim.task import Task, TaskKilled


class Program(Protocol):
    """The part of a program that its lifecycle uses."""

    sim: Simulation

    @property
    def name(self) -> str: ...

    def write(self, stream: str, text: str) -> None: ...

    def report_error(self, error: BaseException) -> None: ...

    def report_runaway(self, error: RunawayProgram) -> None: ...

    def report_exit_call(self, error: Exception) -> None: ...

    def leave_graph(self) -> None: ...

    def report_end(self) -> None: ...


class Lifecycle:
    """The lifecycle of one program, from its first turn to its end.

    :param program: the program.
    :param main: the program's main function, which returns the exit status as for `sys.exit`.
    :ivar task: the task of the main thread.
    :ivar threads: the tasks of the threads that must end before the program ends.
    :ivar before_join: functions to call before the program waits for its threads, in reverse order.
    :ivar exit_calls: the functions that the program registered with `atexit`, with arguments and options.
    :ivar at_exit: functions to call when the program has ended, for any reason.
    :ivar returncode: None while the program runs; negative for a signal, as in `subprocess`.
    :ivar killed_by: the signal that ended the program, or None.
    :ivar is_dead: whether the program has ended; its stack may still unwind, but its actions have no effect.
    """

    def __init__(self, program: Program, main: Callable[[], object]) -> None:
        self.threads: list[Task] = []
        self.before_join: list[Callable[[], object]] = []
        self.exit_calls: list[tuple[Callable[..., object], tuple[Any, ...], dict[str, Any]]] = []
        self.at_exit: list[Callable[[], object]] = []
        self.returncode: int | None = None
        self.killed_by: int | None = None
        self.is_dead = False
        self._program = program
        self._main = main
        self.task = Task(program.sim, self._run, name=program.name, owner=program)
        self.task.add_done_callback(self._end_unbegun)

    def start_thread(self, body: Callable[[], object], name: str, daemon: bool, *, at_once: bool = False) -> Task:
        """Start another task of the program, and return it.

        :param body: the function to run in the task.
        :param name: the name of the task.
        :param daemon: whether the program may end before this task does.
        :param at_once: whether the task runs up to its first wait before this call returns.
        """
        task = Task(self._program.sim, lambda: self._run_thread(body), name=name, owner=self._program)
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
            self._program.report_runaway(error)
            self.returncode = 1
            self.task.kill()
            return None

    def vanish(self) -> None:
        """Kill the program.

        The `finally` blocks still run while the stack unwinds, but have no effect, because a real killed program does not run
        them.
        """
        self.is_dead = True
        self._program.leave_graph()
        self.task.kill()

    def exit_now(self, code: int) -> None:
        """End the program immediately without cleaning up, like `os._exit`. Only the program itself may call this."""
        self.returncode = code
        self.vanish()
        self.task.park()

    def _run(self) -> None:
        code: int | None = None
        try:
            code = self._main_exit_code()
            self._join_threads()
            self.run_exit_calls()
        finally:
            if self.returncode is None:
                killed = code is None or self.killed_by is not None
                self.returncode = -(self.killed_by or Signals.SIGKILL) if killed else code
            self._end()

    def _end_unbegun(self, task: Task) -> None:
        """End a program that received a signal before its first turn."""
        if self.returncode is None:
            interrupted = isinstance(task.exception, KeyboardInterrupt)
            self.returncode = -(Signals.SIGINT if interrupted else self.killed_by or Signals.SIGKILL)
            self._end()

    def _main_exit_code(self) -> int:
        try:
            return self._exit_code(self._main())
        except SystemExit as end:
            return self._exit_code(end.code)
        except KeyboardInterrupt as error:
            self._program.report_error(error)
            return -Signals.SIGINT
        except RunawayProgram as error:
            self._program.report_runaway(error)
            return 1
        except TaskKilled:
            raise
        except BaseException as error:
            self._program.report_error(error)
            return 1

    def _exit_code(self, value: object) -> int:
        """Return the exit status of `sys.exit(value)`.

        The status is 0 for None, and the lowest eight bits of an integer. Any other value is printed, and the status is 1.
        """
        if value is None:
            return 0
        if isinstance(value, int):
            return value & 0xFF
        self._program.write('stderr', f'{value}\n')
        return 1

    def run_exit_calls(self) -> None:
        """Call the functions that the program registered with `atexit`, in reverse order."""
        while self.exit_calls:
            function, arguments, options = self.exit_calls.pop()
            try:
                function(*arguments, **options)
            except Exception as error:
                self._program.report_exit_call(error)

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
        self.is_dead = True
        for thread in self.threads:
            if not thread.finished:
                thread.kill()
        self._program.leave_graph()
        self._program.report_end()
