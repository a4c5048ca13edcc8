"""A host that starts the programs of a launch as real processes on the real rclpy. Launch itself does not change."""

from __future__ import annotations

import fcntl
import os
import shlex
import sys
import time
from functools import cached_property
from tempfile import TemporaryDirectory
from typing import TextIO

from edulaunch.engine.packages import Index, Program
from edulaunch.engine.processes.host import Host
from edulaunch.engine.processes.host_face import OnExit, OnOutput
from edulaunch.engine.processes.process import Process
from edulaunch.engine.processes.real import RealProcess
from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.extras.native.command import HOME, command
from edulaunch.extras.native.environment import Environment, needed
from edulaunch.extras.native.loopback import confined

NATIVE_KINDS = ('entry_point', 'script', 'module')
ROS2 = Program('ros2', '', 'ros2', 'ros2')
HERE_COMMANDS = ('launch', 'run', 'component standalone')
"""The commands of ros2 that only start programs. They run in a simulation whose programs are real, like launch itself."""
_ROS2_FILE = """#!/bin/sh
case "$1 $2 " in
{here}) PYTHONPATH={home} exec {python} -m edulaunch.extras.network.real_command {lock} "$@";;
esac
unset PYTHONPATH
exec {real} ros2 "$@"
"""


class NativeHost(Host):
    """A host whose programs are real processes.

    A program that cannot run (C++ in a workspace, an absent package) only explains the reason, as in the simulation.
    """

    _commands: TemporaryDirectory[str] | None = None
    _lock: TextIO

    @cached_property
    def runs(self) -> list[NativeRun]:
        """Return the programs that were started, in order."""
        return []

    @cached_property
    def environment(self) -> Environment:
        """Return the environment of the real rclpy.

        :raises UnusableInput: when the environment is not installed.
        """
        return needed()

    def start(
        self, spec: ProcessSpec, on_output: OnOutput | None = None, on_exit: OnExit | None = None, *, index: Index | None = None
    ) -> Process | RealProcess:
        """Start a program; see :meth:`Host.start`."""
        index = index or self._index_here()
        known = self.known_command(spec, index)
        if known is not None:
            argv, program = known.argv, known.program
            is_here = ' '.join([*argv[1:3], '']).startswith(tuple(f'{words} ' for words in HERE_COMMANDS))
            if known.tool == ROS2.kind and not is_here:
                program = ROS2
            if program is not None and program.kind in (*NATIVE_KINDS, 'ros2'):
                return self._start_real(spec, argv, program, index, on_output, on_exit)
        run = self._run(spec, on_output, on_exit)
        if known is None:
            spec = spec._replace(env=self._environment(spec, index))
        return super().start(spec, run.hear, run.end, index=index)

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
        environment = self._environment(spec, index)
        environment.pop('PYTHONPATH', None)
        environment['PYTHONUNBUFFERED'] = '1'
        words = (*command(self.environment, program, spec, index), *argv)
        run = self._run(spec, on_output, on_exit)
        real = NativeProcess(self, spec._replace(argv=words, shell=False, env=environment), run.hear, run.end)
        real.run = run
        self.real_programs.append(real)
        return real

    def _environment(self, spec: ProcessSpec, index: Index) -> dict[str, str]:
        environment = confined(self.env if spec.env is None else spec.env)
        environment['PATH'] = os.pathsep.join([self.commands(spec, index), environment.get('PATH', os.defpath)])
        return environment

    def commands(self, spec: ProcessSpec, index: Index) -> str:
        """Return a folder with a command `ros2` for programs that start `ros2` themselves. Create the folder on first use.

        Background programs of this `ros2` end with this process, even after SIGKILL, because they wait for its lock.
        """
        if self._commands is None:
            self._commands = TemporaryDirectory(prefix='edulaunch-ros2-')
            lock, path = (os.path.join(self._commands.name, name) for name in ('lock', 'ros2'))
            self._lock = open(lock, 'w')  # noqa: SIM115  # `close` closes it
            fcntl.flock(self._lock, fcntl.LOCK_EX)
            words = command(self.environment, ROS2, spec._replace(name='ros2'), index, parent=lock)
            text = _ROS2_FILE.format(
                here='|'.join(f'"{words} "*' for words in HERE_COMMANDS),
                home=shlex.quote(HOME),
                python=shlex.quote(sys.executable),
                lock=shlex.quote(lock),
                real=shlex.join(words),
            )
            with open(path, 'w', encoding='utf-8') as file:
                file.write(text)
            os.chmod(path, 0o700)
        return self._commands.name

    def close(self) -> None:
        """Close the host; see `Host.close`. Background commands of ros2 end, too."""
        super().close()
        if self._commands is not None:
            self._lock.close()
            self._commands.cleanup()

    def _run(self, spec: ProcessSpec, on_output: OnOutput | None, on_exit: OnExit | None) -> NativeRun:
        self.runs.append(NativeRun(spec.name, on_output, on_exit))
        return self.runs[-1]


class NativeProcess(RealProcess):
    """A program on the real rclpy.

    :ivar run: the output and the end of the program.
    """

    run: NativeRun

    def send_signal(self, signum: int) -> None:
        """Implement `RealProcess.send_signal`."""
        self.run.signalled_s = min(self.run.signalled_s, time.time())
        super().send_signal(signum)


class NativeRun:
    """The output and the end of one program.

    :ivar written: the output as (time, stream, string). Times are seconds since 1970.
    :ivar started_s: when the program started.
    :ivar ended_s: when the program ended; None while it runs.
    :ivar signalled_s: when the program received its first signal; infinite without a signal.
    """

    def __init__(self, name: str, on_output: OnOutput | None, on_exit: OnExit | None) -> None:
        self.name = name
        self.written: list[tuple[float, str, str]] = []
        self.returncode: int | None = None
        self.started_s = time.time()
        self.ended_s: float | None = None
        self.signalled_s = float('inf')
        self._on_output, self._on_exit = on_output, on_exit

    def hear(self, stream: str, text: str) -> None:
        """Record output of the program."""
        self.written.append((time.time(), stream, text))
        if self._on_output is not None:
            self._on_output(stream, text)

    def end(self, returncode: int) -> None:
        """Record the end of the program."""
        self.returncode, self.ended_s = returncode, time.time()
        if self._on_exit is not None:
            self._on_exit(returncode)
