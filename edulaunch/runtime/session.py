"""The composition root: the only place that wires simulation, graph, packages, processes and recorder together."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Mapping, Sequence
from copy import deepcopy
from types import TracebackType
from typing import Any, TextIO

from edulaunch.engine.graph.graph import Graph
from edulaunch.engine.packages import Index
from edulaunch.engine.packages.discovery import folder_of, install_folders, workspaces_of_command
from edulaunch.engine.processes.host import Host
from edulaunch.engine.processes.process import Process
from edulaunch.engine.processes.real_machine import machine_roots, with_real_paths
from edulaunch.engine.processes.streams import streams_of_programs
from edulaunch.engine.processes.watchdog import Watchdog
from edulaunch.engine.recording import Recorder, Recording
from edulaunch.engine.recording.views import view
from edulaunch.engine.sim.interruption import Interruption
from edulaunch.engine.sim.pacing import Pacer
from edulaunch.engine.sim.simulation import EPOCH_NS, Simulation
from edulaunch.engine.underlay_place import engine_folder, underlay_prefix
from edulaunch.errors import UnusableInput
from edulaunch.ros.sources import read_source
from edulaunch.ros.sourcing import source
from edulaunch.runtime.excerpt import Excerpt
from edulaunch.runtime.fittings import command_set, hint_of
from edulaunch.runtime.keeping import advice_or_why_not, run_kept
from edulaunch.runtime.launch_process import LaunchRun, describe
from edulaunch.runtime.launching import find_launch_file
from edulaunch.runtime.plugins import package_folders
from edulaunch.runtime.still_busy import StillBusy

PathLike = str | os.PathLike[str]
TURN_LIMIT_S = 2.0
MOST_TRACES = 8
"""A machine on which somebody launches all day keeps what the last launches did."""


class Session:
    """A simulated machine with ROS 2 on it, on which launch files are run.

    :param seed: of all randomness.
    :param workspaces: folders with packages (a colcon workspace, its `install` folder, or source packages), searched in this
        order before the underlay.
    :param env: environment of everything that runs; default: a copy of this program's, with USER set.
    :param stdin: for programs that read their keyboard, by launch name ('game-2', or 'game' for each so called) or executable:
        a text, which is there from the start; a list of (simulated seconds, text), each typed at its time; or an open text
        file such as `sys.stdin` (while a program waits for it, simulated time keeps pace with real time).
    :param console: called as console(stream, text) with everything that launch prints.
    :param turn_limit_s: a program that keeps its turn for so many seconds of processor time is stopped, a few times later when
        it still works on something (see `Watchdog`); 0: none is.
    :ivar traces: what each launch on it did, the last ones; see `edulaunch.advice.plan.launch_trace`.
    :ivar steps_launches: whether a launch that begins stops before its first action.
    :param start_ns: what the clock shows at the beginning, in ns since 1970.
    :param near: of two packages with one name, the one that is nearer to this folder counts. None means the current folder.
    """

    simulation_class = Simulation
    recorder_class: type[Recorder] = Recorder
    host_class = Host

    def __init__(
        self,
        *,
        seed: int = 0,
        workspaces: Sequence[PathLike] = (),
        env: Mapping[str, str] | None = None,
        stdin: Mapping[str, str | Sequence[tuple[float, str]] | TextIO] | None = None,
        console: Callable[[str, str], object] | None = None,
        turn_limit_s: float = TURN_LIMIT_S,
        start_ns: int = EPOCH_NS,
        near: str | None = None,
    ) -> None:
        source()
        self.sim = self.simulation_class(seed, start_ns)
        self.recorder = self.recorder_class(self.sim)
        self.graph = Graph(self.sim, self.recorder)
        self.index = index_for(workspaces, near)
        self.console = console
        self.host = self.host_class(
            self.sim,
            self.graph,
            self.index,
            env=machine_environment(env, self.index),
            command_set=command_set(),
            hint_of=hint_of,
            stdin=stdin,
        )
        self.host.watchdog = Watchdog(self.sim, turn_limit_s) if turn_limit_s else None
        self.recorder.overlay = self.host.overlay(self.index)
        self.launches: list[LaunchRun] = []
        self.traces: list[Any] = []
        self.steps_launches = False
        self.recorder.beside['launches'] = self.traces
        self.host.make_launch_observer = self._trace_of
        self.follow: Callable[[int | None, Callable[[], bool]], object] | None = None
        self._name_roots([os.path.abspath(os.fspath(path)) for path in workspaces])

    def __enter__(self) -> Session:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        self.close()

    def _name_roots(self, workspaces: list[str]) -> None:
        ours = ((underlay_prefix(), '@underlay'), (engine_folder(), '@edulaunch'))
        own = [*ours, *((path, f'@workspace{number}') for number, path in enumerate(workspaces))]
        self.recorder.roots = list(with_real_paths(own))

    def _trace_of(self, process: Process) -> Any:
        """What observes a launch that begins; the oldest ones that have ended are let go."""
        trace = view('launch_trace')(process)
        if self.steps_launches:
            trace.stepper.go('into')
        ended = [one for one in self.traces if one.is_over]
        for one in ended[: max(0, len(self.traces) + 1 - MOST_TRACES)]:
            self.traces.remove(one)
        self.traces.append(trace)
        return trace

    def let_go(self) -> None:
        """Let a launch that waits before an action continue, without further stops."""
        if self.sim.is_suspended:
            for trace in self.traces:
                trace.stepper.go('go')
            self.sim.step()

    def launch(
        self,
        path_or_package: PathLike,
        file: str | None = None,
        arguments: Mapping[str, str] | None = None,
        *,
        interactive: bool = False,
        debug: bool = False,
    ) -> LaunchRun:
        """Begin `ros2 launch`: a launch file by path, or by package and file name. It runs when the simulation does.

        :param arguments: launch arguments by name; values are used as text.
        :raises UnusableInput: when there is no such file or package; texts are those of `ros2 launch`.
        """
        path = find_launch_file(self.index, path_or_package, file)
        names = (path, self.index.source_path(path))  # a recording names the student's own file
        places = dict.fromkeys(map(os.path.dirname, names))
        self.recorder.roots += with_real_paths([(place, '@launch') for place in places])
        launch = LaunchRun(
            self.host, self.recorder, path, dict(arguments or {}), console=self.console, interactive=interactive, debug=debug
        )
        self.launches.append(launch)
        launch.start()
        return launch

    @property
    def is_over(self) -> bool:
        """Whether every launch has ended."""
        return all(launch.is_over for launch in self.launches)

    def run(self, duration_s: float | None = None, speed: float = 0.0) -> bool:
        """Let simulated time pass: `duration_s` seconds more, or until every launch has ended.

        SIGINT (Ctrl-C, a notebook's interrupt button) ends it early, between two steps, and leaves a note in the recording;
        a second one raises KeyboardInterrupt where it finds the program.

        :param speed: simulated seconds per real second; 0 is as fast as possible.
        :returns: whether it was interrupted.
        :raises UnusableInput: when `duration_s` is no number of seconds.
        """
        until = None if duration_s is None else self.sim.now_ns + _nanoseconds(duration_s)
        with StillBusy() as still_busy, streams_of_programs(), Interruption(self.sim, still_busy.press) as interruption:
            if self.follow is not None:
                self.follow(until, lambda: interruption.came or (until is None and self.is_over))
            elif speed == 0 and until is not None:
                self.sim.run(until)
            else:
                Pacer(self.sim, speed).run(until, lambda: self.is_over or interruption.came)
        if interruption.came:
            self.note_end()
        return interruption.came

    def note_end(self) -> None:
        """Record that the run ended before its time."""
        self.recorder.note(None, 'interrupted', f'interrupted at {self.sim.elapsed_s:.2f} s of simulated time')

    def interrupt(self) -> None:
        """Press Ctrl-C: every program of the terminal gets SIGINT, launch first."""
        for launch in self.launches:
            launch.interrupt()

    def describe(self) -> None:
        """Tell the recorder what was launched until now, and which folders its digest leaves out."""
        for launch in self.launches:
            launch.describe(self.recorder)
        self.recorder.use_sources(self.index.source_path)
        self.recorder.roots += [root for root in self._installed_roots() if root not in self.recorder.roots]

    def recording(self) -> Recording:
        """End the recording here and give it out."""
        self.describe()
        return self.recorder.recording()

    def glance(self) -> Recording:
        """What happened until now, to be read before time goes on."""
        found = self.recording()
        self.recorder.on = True
        return found

    def of_command(self, pid: int) -> Recording:
        """What one command did from its start to its end (or until now), and what else ran meanwhile; to be read before time goes
        on. `Recording.command` names its own programs.

        :param pid: process id of the command.
        :raises KeyError: when no such program was recorded.
        """
        self.describe()
        excerpt = Excerpt(self.recorder, pid)
        launch = next((describe(launch) for launch in self.launches if launch.process.pid == pid), {})
        found = Recording(excerpt.content(launch), self.recorder.lines)
        found.command, found.beside = excerpt.programs, excerpt.beside
        return found

    def snapshot(self) -> Recording:
        """What happened until now. Later events do not change it, and are kept for the next snapshot."""
        self.describe()
        self.recorder.stop()
        content = self.recorder.content()
        self.recorder.on = True
        return Recording(
            {part: value if part == 'topics' else deepcopy(value) for part, value in content.items()}, self.recorder.lines
        )

    def _installed_roots(self) -> list[list[str]]:
        """Where packages and their modules lie: a workspace gives the same digest built and from source. And what else differs
        from machine to machine.
        """
        prefixes = [path for path in self.index.search_paths() if path != underlay_prefix()]
        own = [*((path, '@prefix') for path in prefixes), *((path, '@python') for path in self.index.python_roots())]
        return [*with_real_paths(own), *machine_roots()]

    def close(self) -> None:
        """End everything that still runs. Nothing of that is recorded."""
        self.recorder.stop()
        self.host.close()


def run(
    path_or_package: PathLike,
    file: str | None = None,
    *,
    arguments: Mapping[str, object] | None = None,
    duration_s: float = 20.0,
    seed: int = 0,
    workspaces: Sequence[PathLike] | None = None,
    console: Callable[[str, str], object] | None = None,
) -> Recording:
    """Run a launch file in the simulation and return the recording of it.

    Interrupted by Ctrl-C, a notebook's interrupt button, SIGTERM, SIGHUP or SIGQUIT, it returns what was recorded until then; a
    warning says so.

    :param path_or_package: path of a launch file; or a package, with `file` the name of a launch file in it.
    :param arguments: launch arguments by name, as on the command line.
    :param duration_s: simulated seconds to run; what runs then is stopped without being recorded.
    :param seed: equal launch file, arguments and seed give the same recording, byte for byte.
    :param workspaces: folders with the student's packages; default: those that `edulaunch launch` finds from here, see
        :func:`~edulaunch.engine.packages.discovery.find_workspaces`. An empty list is none.
    :param console: called as console(stream, text) with everything that launch prints; without one, only what went wrong is told,
        one line each on the error stream: programs that died and why, misspelt launch arguments, callbacks that wait for ever.
    :raises UnusableInput: when the file or package does not exist.
    :raises LaunchFileError: when the launch file cannot be loaded or one of its actions fails; with ROS 2's own text, the
        file and line, and what to try.
    """
    texts = {name: str(value) for name, value in (arguments or {}).items()}
    folders = workspaces_of_command((), path_or_package) if workspaces is None else workspaces
    with Session(seed=seed, workspaces=folders, console=console, near=folder_of(path_or_package)) as session:
        launch = session.launch(path_or_package, file, texts)
        run_kept(lambda: session.run(duration_s), session.sim.stop, session.note_end)
        launch.raise_error()
        recording = session.recording()
    if console is None:
        for line in advice_or_why_not(lambda: view('closing_lines')(recording)):
            print(line, file=sys.stderr)
    return recording


def _nanoseconds(duration_s: float) -> int:
    try:
        found = round(duration_s * 1e9)
    except (OverflowError, TypeError, ValueError):
        found = -1
    if found < 0:
        problem = f'duration_s is {duration_s!r}, and simulated seconds are expected'
        raise UnusableInput(problem, help='write a number that is not below 0: duration_s=5')
    return found


def index_for(workspaces: Sequence[PathLike], near: str | None = None) -> Index:
    """An index of the workspaces over the packages of plug-ins, over the underlay.

    :param near: of two packages with one name, the one that is nearer to this folder counts. None means the current folder.
    """
    built, sources = install_folders(workspaces)
    near = os.getcwd() if near is None else near
    return Index([*built, underlay_prefix()], [*sources, *package_folders()], read_source=read_source, near=near)


def machine_environment(env: Mapping[str, str] | None, index: Index) -> dict[str, str]:
    """The environment of the simulated machine: ROS 2 Jazzy and the workspaces of an index are sourced in it, and there is a
    user.
    """
    found = dict(os.environ if env is None else env)
    found.setdefault('USER', 'student')
    found['PATH'] = os.pathsep.join(filter(None, [os.path.join(underlay_prefix(), 'bin'), found.get('PATH')]))
    found.update(ROS_DISTRO='jazzy', ROS_VERSION='2', ROS_PYTHON_VERSION='3')
    found['AMENT_PREFIX_PATH'] = os.pathsep.join(index.search_paths())
    return found
