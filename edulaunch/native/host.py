"""Starts the programs of a launch as real processes on the real rclpy; launch itself stays what it is."""

from __future__ import annotations

import os
import time
from functools import cached_property
from typing import Any

from edulaunch.native.command import command
from edulaunch.native.environment import Environment, needed
from edulaunch.packages import Index, Program
from edulaunch.processes.host import Host
from edulaunch.processes.process import OnExit, OnOutput, Process
from edulaunch.processes.real import RealProcess
from edulaunch.processes.spec import ProcessSpec
from edulaunch.session import Session

NATIVE_KINDS = ('entry_point', 'script', 'module')
HERE_VERBS = ('launch', 'run')
"""Commands of ros2 that only start programs: they stay in this process."""


class NativeHost(Host):
    """A host whose programs are real processes.

    What only says why it cannot run (a C++ program of a workspace, one of an absent package) says so as in the simulation.
    """

    @cached_property
    def runs(self) -> list[NativeRun]:
        """The programs that were started, in order."""
        return []

    @cached_property
    def environment(self) -> Environment:
        """The real rclpy's.

        :raises UnusableInput: when it is not installed.
        """
        return needed()

    def start(
        self, spec: ProcessSpec, on_output: OnOutput | None = None, on_exit: OnExit | None = None, *, index: Index | None = None
    ) -> Process | RealProcess:
        """Start a program: see :meth:`Host.start`."""
        index = index or self._index_here()
        known = self._known_command(spec, index)
        if known is not None:
            argv, program = known
            if program is None and (len(argv) < 2 or argv[1] not in HERE_VERBS):
                program = Program('ros2', '', 'ros2', argv[0])
            if program is not None and program.kind in (*NATIVE_KINDS, 'ros2'):
                return self._start_real(spec, argv, program, index, on_output, on_exit)
        return super().start(spec, on_output, on_exit, index=index)

    def _start_real(
        self,
        spec: ProcessSpec,
        argv: list[str],
        program: Program,
        index: Index,
        on_output: OnOutput | None,
        on_exit: OnExit | None,
    ) -> RealProcess:
        for word in argv:
            if word in self.generated_files:
                self.generated_files[word].write()
        environment = dict(self.env if spec.env is None else spec.env)
        environment.pop('PYTHONPATH', None)
        environment['PYTHONUNBUFFERED'] = '1'
        words = (*command(self.environment, program, spec, index), *argv)
        run = NativeRun(self, spec.name, on_output, on_exit)
        self.runs.append(run)
        real = RealProcess(self, spec._replace(argv=words, shell=False, env=environment), run.hear, run.end)
        self.real_programs.append(real)
        return real


class NativeRun:
    """What one program wrote, and how it ended.

    :ivar written: (seconds since the start, stream, text).
    """

    def __init__(self, host: Host, name: str, on_output: OnOutput | None, on_exit: OnExit | None) -> None:
        self.name = name
        self.written: list[tuple[float, str, str]] = []
        self.returncode: int | None = None
        self._host = host
        self._on_output, self._on_exit = on_output, on_exit

    def hear(self, stream: str, text: str) -> None:
        """It wrote something."""
        self.written.append((self._host.sim.elapsed_s, stream, text))
        if self._on_output is not None:
            self._on_output(stream, text)

    def end(self, returncode: int) -> None:
        """It ended."""
        self.returncode = returncode
        if self._on_exit is not None:
            self._on_exit(returncode)


class NativeSession(Session):
    """A session whose programs are real processes. Its clock shows the time of day.

    They find each other on this computer only, unless ROS_AUTOMATIC_DISCOVERY_RANGE says otherwise.
    """

    host_class = NativeHost

    def __init__(self, **options: Any) -> None:
        env = dict(os.environ if options.get('env') is None else options['env'])
        env.setdefault('ROS_AUTOMATIC_DISCOVERY_RANGE', 'LOCALHOST')
        super().__init__(**{**options, 'env': env, 'start_ns': time.time_ns()})
