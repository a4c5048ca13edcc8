"""The machine of a notebook: its Session, the background jobs (with `&`), and the server for terminals."""

from __future__ import annotations

import os
import shlex
import time
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any, NamedTuple

from edulaunch.advice.reader import reader_here
from edulaunch.advice.rendering import end_of_run_lines
from edulaunch.desk.cli.launch import split_words
from edulaunch.desk.machine import wire
from edulaunch.desk.machine.client import ask, has_terminals_machine
from edulaunch.desk.machine.connection import RemoteInput
from edulaunch.desk.machine.live import end_programs, finish
from edulaunch.desk.machine.terminals import doctors_text, is_doctor
from edulaunch.desk.notebook.hosting import Hosting
from edulaunch.desk.notebook.line import Line, number_of
from edulaunch.engine.packages import Index
from edulaunch.engine.processes.process import Process
from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.engine.recording import Recording
from edulaunch.engine.sim.loops import outer_loop_set_aside
from edulaunch.engine.sim.simulation import EPOCH_NS
from edulaunch.errors import UnusableInput
from edulaunch.runtime.launch_process import LaunchRun
from edulaunch.runtime.launching import find_launch_file
from edulaunch.runtime.session import Session, index_for

LAUNCH_S = 20.0
COMMAND_S = {'topic echo': 1.0}
OTHER_S = 5.0
"""Simulated seconds until Ctrl-C without `--for`: for launches, for commands with much output, and for others."""
PRESS_S = 1.0
"""Simulated seconds that pass for a key: a turtle moves for this long."""
SIZE = (80, 24)
OTHER_MACHINE = """note: open terminals use another machine, so this launch does not appear there
  help: start your commands again in the terminals to use this machine
"""
BESIDE = """note: {job} still runs, so this launch starts beside it at t = {time:.2f} s on the same machine
  help: to compare runs, end it first: {stop}
"""


class BackgroundProgram(NamedTuple):
    """A background job, with a number as in a shell."""

    number: int
    process: Process
    text: str

    def __str__(self) -> str:
        code = self.process.returncode
        state = 'Running' if code is None else 'Done' if code == 0 else f'Exit {code}'
        return f'[{self.number}]  {self.process.pid}  {state:<10}{self.text}'


class Jobs:
    """All background jobs, in the order in which they were started."""

    def __init__(self) -> None:
        self._jobs: list[BackgroundProgram] = []

    def add(self, process: Process, text: str) -> BackgroundProgram:
        """Add a job for a process. Return the job.

        :param process: the process.
        :param text: the line that the user typed.
        """
        self._jobs.append(BackgroundProgram(max((job.number for job in self._jobs), default=0) + 1, process, text))
        return self._jobs[-1]

    def running(self) -> list[BackgroundProgram]:
        """Return the jobs that have not ended."""
        return [job for job in self._jobs if job.process.returncode is None]

    def chosen(self, number: str) -> list[BackgroundProgram]:
        """Return the job with this number, or all jobs if `number` is empty.

        :raises UnusableInput: for an unknown number.
        """
        found = [job for job in self._jobs if number in ('', str(job.number), f'%{job.number}')]
        if number and not found:
            known = ', '.join(str(job.number) for job in self._jobs)
            raise UnusableInput(
                f'there is no job {number}',
                help=f'choose one of the jobs {known}' if known else 'end a command with & to start a job',
            )
        return found

    def forget_ended(self) -> None:
        """Remove the jobs that have ended, as a shell does after it has listed them."""
        self._jobs = self.running()

    def clear(self) -> None:
        """Remove all jobs, because their machine has ended."""
        self._jobs.clear()


class NotebookMachine:
    """Runs the `ros2` command lines of a notebook on one machine, which terminals can use, too.

    A launch starts a new machine, unless a program runs in the background (with `&`) or in a terminal. All other commands run
    on the current machine, together with the programs that still run.

    :param write: a function that receives all output, as write(stream, text).
    :param workspaces: a function that returns the folders with packages for a new machine.
    :ivar show_keyboard: a function that is called as show_keyboard(press, title) for a program that reads keys. The function
        `press` sends keys to the program and returns its output.
    """

    def __init__(self, write: Callable[[str, str], object], workspaces: Callable[[], Sequence[str]]) -> None:
        self.hosting = Hosting()
        self.session: Session | None = None
        self._write = write
        self._workspaces = workspaces
        self._jobs = Jobs()
        self._foreground: LaunchRun | None = None
        self._asked: list[BackgroundProgram] = []
        self.show_keyboard: Callable[[Callable[[str], str], str], object] = lambda press, title: None

    def _new_session(self, seed: int) -> Session:
        start_ns = time.time_ns() if self.hosting.joins_next else EPOCH_NS
        return Session(seed=seed, workspaces=list(self._workspaces()), console=self._write, start_ns=start_ns)

    def _index(self, session: Session) -> Index:
        """Return the package index for a command. It includes the current content of the workspaces, which a cell may change."""
        found = list(self._workspaces())
        return index_for(found) if found else session.index

    def _use(self, session: Session) -> Session:
        """Use a session as the notebook's machine from now on. Close the previous session."""
        if self.session is not session:
            if self.session is not None:
                self.session.close()
            self._jobs.clear()
            self.session = session
        self.hosting.serve(session)
        return session

    def launch(self, line: Line) -> Recording | None:
        """Run a launch file on a new machine, or on the current machine if programs run there in the background or in a terminal.

        Return None if the line ends with `&`. The previous machine is not closed before the new launch has started
        successfully.
        """
        words = line.words[1:]
        if not words:
            raise UnusableInput('no launch file is named', help='write %ros2 launch PACKAGE FILE name:=value --for SECONDS')
        here = self.session
        stays = here is not None and (line.stays or bool(self._jobs.running()) or self.hosting.has_programs())
        session = here if here is not None and stays else self._new_session(line.seed)
        if self.hosting.joins_next and session is not here:
            self._use(session)
            self._write('stdout', f'{self.hosting.join_network(True)}\n')
        self._say_what_runs(here, stays)
        launch = self._begin(session, words, stays)
        note = OTHER_MACHINE if here is None and has_terminals_machine() else ''
        if line.stays:
            self._use(session)
            job = self._jobs.add(launch.process, f'ros2 launch {shlex.join(words)}')
            self._write('stdout', f'{job}\n')
            session.run(0.0)
        else:
            session.run(LAUNCH_S if line.seconds is None else line.seconds)
        if launch.error is None or here is None or self.session is session:
            self._use(session)
        else:
            session.close()
        launch.raise_error()
        if line.stays:
            return None
        self._foreground = launch
        self._write('stderr', note)
        found = session.snapshot()
        if not line.quiet:
            for text in self._advice(session, launch.process):
                self._write('stderr', f'{text}\n')
        return found

    def _advice(self, session: Session, process: Process, typed: str = '') -> list[str]:
        """Return the lines of advice to print below a cell. They are only about the command of that cell."""
        helped = session.host.hints.helped(process.pid)
        return end_of_run_lines(session.of_command(process.pid), helped=helped, typed=typed)

    def _say_what_runs(self, session: Session | None, stays: bool) -> None:
        """Print a note if a launch runs together with programs of earlier cells or terminals, because the results may differ."""
        if session is None or not stays:
            return
        for job in self._jobs.running():
            note = BESIDE.format(job=f'[{job.number}] {job.text}', time=session.sim.elapsed_s, stop=f'%ros2 stop {job.number}')
            self._write('stderr', note)

    def _begin(self, session: Session, words: list[str], beside: bool) -> LaunchRun:
        """Start the launch. If `beside` is True, first end the launch of the previous cell, because its time is over."""
        package_or_file, file, arguments = split_words(words[0], words[1:])
        find_launch_file(session.index, package_or_file, file)
        if beside and self._foreground is not None:
            end_programs(session, [self._foreground.process])
        self._foreground = None
        return session.launch(package_or_file, file, arguments)

    def own_word(self, word: str, *values: str) -> None:
        """Run `jobs`, `stop` or `wait`. In a notebook, these words replace a shell's `jobs`, Ctrl-C and `sleep`."""
        session = self.session
        if word == 'wait':
            seconds = number_of(values[0] if values else None, 'wait')
            if session is not None:
                session.run(seconds)
            return
        jobs = self._jobs.chosen(values[0] if values else '')
        if word == 'stop' and session is not None:
            programs = [job.process for job in jobs]
            if self._foreground is not None and not values:
                programs.append(self._foreground.process)
            end_programs(session, programs)
        for job in jobs:
            self._write('stdout', f'{job}\n')
        self._jobs.forget_ended()

    def _give_keyboards(self, session: Session) -> None:
        """Show a keyboard for each program that has begun to read keys."""
        while self._asked:
            job = self._asked.pop(0)
            self.show_keyboard(partial(self._press, session, job), job.text)

    def _press(self, session: Session, job: BackgroundProgram, keys: str) -> str:
        """Send keys to a job, and run the simulation for a short time. Return the output of that time."""
        printed: list[str] = []
        job.process.on_output = lambda stream, text: printed.append(text)
        with self.hosting.cell(), outer_loop_set_aside():
            job.process.streams.stdin.feed(keys)
            session.run(PRESS_S)
        job.process.on_output = self._write
        return ''.join(printed)

    def command(self, line: Line) -> None:
        """Run a command to its end, or send it SIGINT when its time is over."""
        words, seconds = line.words, line.seconds
        limit_s = COMMAND_S.get(' '.join(words[:2]), OTHER_S) if seconds is None else seconds
        is_guest = self.session is None and not line.stays and not line.shell and has_terminals_machine()
        if is_guest and ask(['ros2', *words], self._write, seconds=limit_s) is not None:
            return
        session = self._use(self.session or self._new_session(0))
        argv = (f'ros2 {line.shell}',) if line.shell else ('ros2', *words)
        spec = ProcessSpec(argv=argv, name='ros2', cwd=os.getcwd(), shell=bool(line.shell))
        if not session.host.knows(spec):
            raise UnusableInput(
                f'{argv[0]!r} needs a real shell', help='run one command at a time, or join ros2 commands with | > < && ;'
            )
        ended = None if line.stays else lambda code: session.sim.stop()
        process: Any = session.host.start(spec, self._write, ended, index=self._index(session))
        if line.stays:
            job = self._jobs.add(process, f'ros2 {line.shell or shlex.join(words)}')
            self._write('stdout', f'{job}\n')

            def on_message(kind: int, payload: bytes = b'') -> None:
                if kind == wire.READ:
                    self._asked.append(job)

            process.streams.stdin = RemoteInput(on_message, True, SIZE)
            session.run(0.0)
            self._give_keyboards(session)
            return

        def on_late(interrupted: bool) -> None:
            pressed = f'^C (edulaunch pressed it at t = {session.sim.elapsed_s:.2f} s; set the time with --for SECONDS)\n'
            if interrupted or seconds is None:
                self._write('stdout', '^C\n' if interrupted else pressed)

        finish(session, process, limit_s, on_late)
        if words[:1] == ['run'] and not line.quiet:
            for text in self._advice(session, process, process.name):
                self._write('stderr', f'{text}\n')
        elif is_doctor(argv):
            self._write('stdout', doctors_text(session, reader_here()))
