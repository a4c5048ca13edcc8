"""The composition root: the only module that connects simulation, graph, packages, processes and recorder."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Mapping, Sequence
from copy import deepcopy
from types import TracebackType
from typing import Any, TextIO

from edulaunch.engine.graph.graph import Graph
from edulaunch.engine.packages import Index
from edulaunch.engine.packages.discovery import find_workspaces, folder_of, install_folders, workspaces_of_command
from edulaunch.engine.processes.host import Host
from edulaunch.engine.processes.process import Process
from edulaunch.engine.processes.real_machine import machine_roots, with_real_paths
from edulaunch.engine.processes.spec import ProcessSpec
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
from edulaunch.runtime.set_order import set_lines
from edulaunch.runtime.still_busy import StillBusy

PathLike = str | os.PathLike[str]
TURN_LIMIT_S = 2.0
MOST_TRACES = 8
"""A machine on which a user launches all day keeps the traces of the last launches only."""


class Session:
    """A simulated machine with ROS 2 that runs launch files.

    :param seed: the seed of all random numbers.
    :param workspaces: folders with packages (a colcon workspace, its `install` folder, or source packages), searched in this
        order before the packages of edulaunch.
    :param env: the environment of all programs. The default is a copy of this program's environment, with USER set.
    :param stdin: keyboard input of programs, by launch name ('game-2', or 'game' for all programs of that name) or executable. A
        string is available from the start. A list of (simulated seconds, string) types each string at its time. An open text
        file, such as `sys.stdin`, is read when a program waits for input. Meanwhile, simulated time follows real time.
    :param console: a function that is called as console(stream, text) with everything that launch prints.
    :param turn_limit_s: seconds of processor time after which a program that does not yield is stopped (see `Watchdog`); 0
        disables the limit.
    :ivar traces: the steps of the last launches; see `edulaunch.advice.plan.launch_trace`.
    :ivar steps_launches: whether new launches stop before their first action.
    :param start_ns: the time of the clock at the beginning, in ns since 1970.
    :param near: a folder. If two packages have the same name, the package nearer to this folder is used. The default is the
        current folder.
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
        self.host.lines_in_set_order = set_lines
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
        """Return the observer of a new launch. If there are too many, remove the oldest observers of ended launches."""
        trace = view('launch_trace')(process)
        if self.steps_launches:
            trace.stepper.go('into')
        ended = [one for one in self.traces if one.is_over]
        for one in ended[: max(0, len(self.traces) + 1 - MOST_TRACES)]:
            self.traces.remove(one)
        self.traces.append(trace)
        return trace

    def let_go(self) -> None:
        """Continue a launch that waits before an action, without further stops."""
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
        """Start `ros2 launch` with a launch file by path, or by package and file name. The launch runs when the simulation runs.

        :param path_or_package: path of a launch file, or name of a package.
        :param file: name of a launch file in the package.
        :param arguments: launch arguments by name. The values are passed as strings.
        :param interactive: whether a terminal also sends Ctrl-C to the launched programs. If so, launch does not send it again.
        :param debug: whether to log at level DEBUG, as `ros2 launch --debug` does.
        :raises UnusableInput: when there is no such file or package, with the messages of `ros2 launch`.
        """
        path = find_launch_file(self.index, path_or_package, file)
        names = (path, self.index.source_path(path))  # source_path gives the student's own file, as recordings do
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
        """Return whether every launch has ended."""
        return all(launch.is_over for launch in self.launches)

    def run(self, duration_s: float | None = None, speed: float = 0.0) -> bool:
        """Advance simulated time by `duration_s` seconds, or until every launch has ended.

        SIGINT (Ctrl-C, a notebook's interrupt button) ends the run early, between two steps, and adds a note to the recording.
        A second SIGINT raises KeyboardInterrupt immediately.

        :param duration_s: simulated seconds; None runs until every launch has ended.
        :param speed: simulated seconds per real second; 0 is as fast as possible.
        :returns: whether the run was interrupted.
        :raises UnusableInput: when `duration_s` is not a number of seconds.
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
        """Record that the run ended early."""
        self.recorder.note(None, 'interrupted', f'interrupted at {self.sim.elapsed_s:.2f} s of simulated time')

    def interrupt(self) -> None:
        """Press Ctrl-C in the terminal: every program of the terminal receives SIGINT, and launch receives it first."""
        for launch in self.launches:
            launch.interrupt()

    def describe(self) -> None:
        """Pass the launches so far to the recorder, and the folders that the recording's digest leaves out."""
        for launch in self.launches:
            launch.describe(self.recorder)
        self.recorder.use_sources(self.index.source_path)
        self.recorder.roots += [root for root in self._installed_roots() if root not in self.recorder.roots]

    def recording(self) -> Recording:
        """End the recording now, and return it."""
        self.describe()
        return self.recorder.recording()

    def glance(self) -> Recording:
        """Return the recording so far. Read the result before time advances."""
        found = self.recording()
        self.recorder.on = True
        return found

    def of_command(self, pid: int) -> Recording:
        """Return the records of one command from its start to its end or until now, and of programs that ran at the same time.

        Read the result before time advances. `Recording.command` names the command's own programs.

        :param pid: process ID of the command.
        :raises KeyError: for an unknown program.
        """
        self.describe()
        excerpt = Excerpt(self.recorder, pid)
        launch = next((describe(launch) for launch in self.launches if launch.process.pid == pid), {})
        found = Recording(excerpt.content(launch), self.recorder.lines)
        found.command, found.beside = excerpt.programs, excerpt.beside
        return found

    def snapshot(self) -> Recording:
        """Return a copy of the recording so far. Later events do not change this copy. They appear in the next snapshot."""
        self.describe()
        self.recorder.stop()
        content = self.recorder.content()
        self.recorder.on = True
        return Recording(
            {part: value if part == 'topics' else deepcopy(value) for part, value in content.items()}, self.recorder.lines
        )

    def _installed_roots(self) -> list[list[str]]:
        """Return the folders of packages and modules, and other strings that differ between computers.

        Without these strings, a workspace has the same digest when it is built and when it is used from source.
        """
        prefixes = [path for path in self.index.search_paths() if path != underlay_prefix()]
        own = [*((path, '@prefix') for path in prefixes), *((path, '@python') for path in self.index.python_roots())]
        return [*with_real_paths(own), *machine_roots()]

    def close(self) -> None:
        """End all programs that are still running, without recording this."""
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
    """Run a launch file in the simulation, and return the recording of the run.

    If Ctrl-C, a notebook's interrupt button, SIGTERM, SIGHUP or SIGQUIT interrupts the run, print a warning and return the
    recording so far.

    :param path_or_package: path of a launch file; or a package, with `file` as the name of a launch file in the package.
    :param file: name of a launch file in the package.
    :param arguments: launch arguments by name, as on the command line.
    :param duration_s: simulated seconds to run. Programs that still run are then stopped without being recorded.
    :param seed: the seed of all random numbers. The same launch file, arguments and seed give the same recording, byte for byte.
    :param workspaces: folders with the student's packages. The default is the same as in `edulaunch launch`, see
        :func:`~edulaunch.engine.packages.discovery.find_workspaces`. An empty list uses no workspace.
    :param console: a function that is called as console(stream, text) with everything that launch prints. Without this
        function, edulaunch prints problems on the error stream, one line each: programs that died and why, misspelt launch
        arguments, callbacks that wait forever.
    :param session: further arguments of :class:`Session`, such as `env`, `stdin` and `start_ns`.
    :raises UnusableInput: when the file or package does not exist.
    :raises LaunchFileError: when the launch file cannot be loaded or one of its actions fails. The error has ROS 2's message, the
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
        problem = f'duration_s must be a number of simulated seconds, not {duration_s!r}'
        raise UnusableInput(problem, help='write a number of at least 0, such as duration_s=5')
    return found


def index_for(workspaces: Sequence[PathLike], near: str | None = None) -> Index:
    """Return an index of the workspaces, the packages of plug-ins, and the packages of edulaunch, in this order.

    :param near: a folder. If two packages have the same name, the package nearer to this folder is used. None means the current
        folder.
    """
    built, sources = install_folders(workspaces)
    near = os.getcwd() if near is None else near
    return Index([*built, underlay_prefix()], [*sources, *package_folders()], read_source=read_source, near=near)


def typed_command(words: Sequence[str], name: str, cwd: str, env: Mapping[str, str], index: Index) -> tuple[ProcessSpec, Index]:
    """Return the program that a command line starts, and the index that finds the packages of the command.

    :param cwd: the current folder of the terminal. Packages are looked up in the workspaces of this folder, and in the
        workspaces of a launch file that the command names by path.
    :param env: the environment of the terminal.
    :param index: the index to use if there is no workspace.
    """
    file = _named_file(words, cwd)
    near = cwd if file is None else os.path.dirname(os.path.join(cwd, file))
    workspaces = find_workspaces(cwd, env, file)
    found = index_for(workspaces, near) if workspaces else index
    if os.access(env.get('HOME', ''), os.W_OK):  # `ros2 launch` writes ~/.ros/log, as on a real computer
        env = {'ROS_HOME': os.path.join(env['HOME'], '.ros'), **env}
    return ProcessSpec(argv=tuple(words), name=name, cwd=cwd, env=machine_environment(env, found)), found


def _named_file(words: Sequence[str], cwd: str) -> str | None:
    """Return the launch file or the Python program that a command names by path, or None."""
    count = 1 if words[0] == 'python3' else 2
    if count == 2 and list(words[:2]) != ['ros2', 'launch']:
        return None
    paths = (os.path.join(cwd, word) for word in words[count:] if not word.startswith('-'))
    return next(filter(os.path.isfile, paths), None)


def machine_environment(env: Mapping[str, str] | None, index: Index) -> dict[str, str]:
    """Return the environment of the simulated machine: ROS 2 Jazzy and the workspaces of an index are sourced, and USER is
    set."""
    found = dict(os.environ if env is None else env)
    found.setdefault('USER', 'student')
    found['PATH'] = os.pathsep.join(filter(None, [os.path.join(underlay_prefix(), 'bin'), found.get('PATH')]))
    found.update(ROS_DISTRO='jazzy', ROS_VERSION='2', ROS_PYTHON_VERSION='3')
    found['AMENT_PREFIX_PATH'] = os.pathsep.join(index.search_paths())
    return found
