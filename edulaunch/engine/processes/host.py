"""Starts programs. Commands of the simulation run as simulated processes, and all other commands as real programs of this
machine.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any, Protocol

from edulaunch.engine.graph.graph import Graph
from edulaunch.engine.graph.parameter_files import Entry
from edulaunch.engine.graph.ros_arguments import entries_of_file
from edulaunch.engine.graph.tracer import Tracer
from edulaunch.engine.packages import Index
from edulaunch.engine.processes import real_machine
from edulaunch.engine.processes.commands import CommandSet, Known
from edulaunch.engine.processes.deferred_hints import DeferredHints, HintOf
from edulaunch.engine.processes.finding import Overlay
from edulaunch.engine.processes.host_face import JoinNetwork, OnExit, OnOutput
from edulaunch.engine.processes.inputs import Input, SilentPipe, TypedInput
from edulaunch.engine.processes.process import Process
from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.engine.sim.real_pace import RealPace
from edulaunch.engine.sim.simulation import Simulation
from edulaunch.engine.sim.task import running_task

if TYPE_CHECKING:
    from types import CodeType

    from edulaunch.engine.processes.real import RealLook, RealProcess
    from edulaunch.engine.processes.watchdog import Watchdog

FIRST_PID = 1001


class GeneratedFile(Protocol):
    """A parameter file that launch has generated."""

    def entries(self) -> Sequence[Entry]: ...

    def write(self) -> None: ...

    def remove(self) -> None: ...


class Host:
    """The simulated machine that starts and owns the processes of one simulation.

    :param sim: the simulation in which the programs run.
    :param graph: the graph of the simulation.
    :param index: the packages that programs find by default.
    :param env: the environment that programs inherit.
    :param command_set: the tools and the shell of the machine (default: none).
    :param hint_of: a function that returns the hint for an error, see :class:`DeferredHints` (default: no hints).
    :param stdin: the input of programs, by launch name ('game-2', or 'game' for all programs of this name) or executable. An
        input is a string, a list of (simulated seconds, string), or an open text file. All other programs read an empty
        input; in a launch, this input is a pipe that stays open.
    :cvar is_real: whether programs run on the real rclpy, and query this computer instead of the host.
    :ivar watchdog: stops programs that never wait, or None.
    :ivar join_network: a function that joins a real ROS 2 network, or None where this is impossible. Its arguments are an
        environment, the words of the command's options, and a function that reports joining and leaving. It returns a
        function that leaves the network.
    :ivar where_on_network: a function that describes the joined network and the library that connects to it; it returns None
        without a network.
    :ivar make_launch_observer: a function that creates the observer of a process's launch service, or None.
    :ivar lines_in_set_order: a function that returns the lines of a source that use the order of a set; the recording names
        the first line.
    :ivar unread_stdin: the names in `stdin` whose programs have not been started yet.
    """

    is_real = False

    def __init__(
        self,
        sim: Simulation,
        graph: Graph,
        index: Index,
        *,
        env: Mapping[str, str],
        command_set: CommandSet | None = None,
        hint_of: HintOf | None = None,
        stdin: Mapping[str, Any] | None = None,
    ) -> None:
        self.sim = sim
        self.graph = graph
        self.index = index
        self.tracer: Tracer = graph.tracer
        self.env = dict(env)
        self.processes: list[Process] = []
        self.real_programs: list[RealProcess] = []
        self.pace = RealPace(sim)
        self.command_set = command_set or CommandSet()
        self._stdin = dict(stdin or {})
        self.unread_stdin = list(self._stdin)
        self.hints = DeferredHints(hint_of)
        self.watchdog: Watchdog | None = None
        self.join_network: JoinNetwork | None = None
        self.where_on_network: Callable[[], str | None] = lambda: None
        self.make_launch_observer: Callable[[Any], Any] | None = None
        self.lines_in_set_order: Callable[[bytes], Sequence[int]] = lambda source: ()
        self.compiled: dict[str, tuple[tuple[int, int], CodeType]] = {}
        self.generated_files: dict[str, GeneratedFile] = {}
        """By path: the files that launch has generated for programs. They are on the disk only for real programs."""
        self.goal_ids: set[bytes] = set()
        """All goal ids that were sent. Programs of the same name draw the same numbers, but a server needs unique ids."""
        self._pid = FIRST_PID
        self._overlays: list[tuple[Index, Overlay]] = []

    @cached_property
    def real_look(self) -> RealLook:
        """The observer of the real programs."""
        from edulaunch.engine.processes.real import RealLook

        return RealLook(self)

    def overlay(self, index: Index) -> Overlay:
        """Return the modules and interfaces that the workspaces of an index add to the underlay."""
        for known, overlay in self._overlays:
            if known is index:
                return overlay
        overlay = Overlay(index)
        self._overlays.append((index, overlay))
        return overlay

    def parameter_entries(self, path: str) -> Sequence[Entry]:
        """Return the entries of the parameter file at `path`, which launch may have generated.

        :raises OSError: if the file cannot be opened.
        :raises UnicodeDecodeError: if the file is not UTF-8.
        :raises ParameterFileError: if rcl would reject the content.
        """
        generated = self.generated_files.get(path)
        if generated is not None:
            return generated.entries()
        program = self.program_here()
        return entries_of_file(path if program is None else program.path(path))

    def forget_overlays(self) -> None:
        """Release the overlays that no running program uses."""
        used = [self.index, *(process.index for process in self.processes)]
        self._overlays = [pair for pair in self._overlays if any(pair[0] is index for index in used)]

    def next_pid(self) -> int:
        """Return the next process number. Numbers start at 1001, so that they are the same in every run."""
        pid = self._pid
        self._pid += 1
        return pid

    def stdin_for(self, spec: ProcessSpec) -> Any:
        """Return the input for a program, selected by its launch name or executable. Without a match, return an empty input."""
        from edulaunch.engine.processes.real import RealInput

        names = (spec.name, spec.name.rpartition('-')[0], spec.executable)
        name = next((name for name in names if name in self._stdin), None)
        if name is None:
            return SilentPipe() if spec.has_pipe else Input()
        if name in self.unread_stdin:
            self.unread_stdin.remove(name)
        given = self._stdin[name]
        if isinstance(given, str):
            return Input(given)
        return TypedInput(given) if isinstance(given, (list, tuple)) else RealInput(given, self)

    def program_here(self) -> Process | None:
        """Return the program of this machine whose code is running now. Return None outside the programs of this machine."""
        task = running_task()
        owner = None if task is None else task.owner
        return owner if isinstance(owner, Process) and owner.host is self else None

    def _index_here(self) -> Index:
        program = self.program_here()
        return self.index if program is None else program.index

    def start(
        self, spec: ProcessSpec, on_output: OnOutput | None = None, on_exit: OnExit | None = None, *, index: Index | None = None
    ) -> Process | RealProcess:
        """Start a program. Its code first runs after the agenda's items that are due now.

        :param on_output: called as on_output('stdout' | 'stderr', text) for all output of the program.
        :param on_exit: called once with the return code.
        :param index: the packages that the program finds (default: the packages of the program that starts it).
        :raises FileNotFoundError: if there is no such command.
        :raises PermissionError: if the command is not executable.
        """
        index, starter = index or self._index_here(), self.program_here()
        if starter is not None and starter.cwd is not None:
            spec = spec._replace(cwd=starter.path(spec.cwd or ''))
        known = self.known_command(spec, index)
        if known is None:
            from edulaunch.engine.processes.real import RealProcess

            for word in spec.argv:
                if word in self.generated_files:
                    self.generated_files[word].write()
            real = RealProcess(self, spec, on_output, on_exit)
            self.real_programs.append(real)
            return real
        process = Process(self, spec, self.next_pid(), known.argv, known.main)
        process.index = index
        if index is not self.index:
            process.sourced_path = os.pathsep.join(index.search_paths())
        process.on_output = on_output
        process.on_exit = on_exit
        if starter is not None:
            starter.limit.programs += 2
        return self.adopt(process)

    def start_launched(self, spec: ProcessSpec, on_output: OnOutput, on_exit: OnExit) -> Process | RealProcess:
        """Start the program of a launch action; see :meth:`start`. A dry run only records the program."""
        return self.start(spec, on_output, on_exit)

    def start_command(self, spec: ProcessSpec, on_output: OnOutput, on_exit: OnExit) -> Process | RealProcess:
        """Start a command whose output a launch file needs, even in a dry run; see :meth:`start`."""
        return self.start(spec, on_output, on_exit)

    def adopt(self, process: Process) -> Process:
        """Add a process that was created elsewhere, and start it."""
        if self.watchdog is not None:
            self.watchdog.start()
        real_machine.listen()
        self.processes.append(process)
        self.tracer.process_started(process)
        self.begin(process)
        return process

    def begin(self, process: Process) -> None:
        """Schedule the first turn of a program, after the agenda's items that are due now."""
        process.lifecycle.task.start()

    def knows(self, spec: ProcessSpec) -> bool:
        """Return whether the command of a spec runs in the simulation."""
        return self.known_command(spec) is not None

    def known_command(self, spec: ProcessSpec, index: Index | None = None) -> Known | None:
        """Return the command of a spec, or None if it does not run in the simulation.

        :param index: the packages to search (default: the packages of the program whose code is running).
        """
        packages = index or self._index_here()
        return self.command_set.find(spec, packages, lambda: self.overlay(packages).modules)

    def ended(self, process: Process) -> None:
        """Remove a process that has ended; the process calls this method."""
        self.processes.remove(process)
        self.tracer.process_exited(process)

    def close(self) -> None:
        """End everything immediately, without more simulated time: unwind the tasks of programs, and kill real programs."""
        if self.watchdog is not None:
            self.watchdog.stop()
        for real in list(self.real_programs):
            real.kill()
        for process in list(self.processes):
            process.on_output = process.on_exit = None
            process.lifecycle.task.kill()
            for thread in process.lifecycle.threads:
                thread.kill()
        until = self.sim.now_ns
        self.sim.run(until)
        for file in self.generated_files.values():
            file.remove()
