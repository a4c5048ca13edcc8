"""A host that starts no programs. It records each process that launch would start, and ends the process when launch stops it.

The host also prevents changes that a launch file would make itself with `subprocess`, `os.system`, `open(..., 'w')` or
`os.remove` (see `closed.py`).
"""

from __future__ import annotations

import errno
import gc
import os
from collections import deque
from collections.abc import Callable, Sequence
from shutil import which
from typing import TYPE_CHECKING, Any

from edulaunch.advice.plan.closed import Closed
from edulaunch.engine.graph.parameter_files import Entry
from edulaunch.engine.graph.tracer import Tracer
from edulaunch.engine.packages import Index
from edulaunch.engine.processes.host import Host
from edulaunch.engine.processes.host_face import OnExit, OnOutput
from edulaunch.engine.processes.process import Process
from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.engine.underlay_place import is_students

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext

    from edulaunch.engine.processes.watchdog import RunawayProgram
    from edulaunch.engine.sim.simulation import Simulation

WARNING = 30
LOOKING_UP = ('pkg', 'interface')
"""Verbs of `ros2` that only query information."""


class ImaginaryProcess:
    """A process that does nothing until a signal ends it.

    :param on_exit: a function that is called with the return code.
    :ivar came_back: whether the process has ended before and was started again.
    """

    came_back = False

    def __init__(self, spec: ProcessSpec, pid: int, on_exit: OnExit | None) -> None:
        self.spec = spec
        self.pid = pid
        self.returncode: int | None = None
        self._on_exit = on_exit

    def send_signal(self, signum: int) -> None:
        """End the process, as a signal ends a program without a signal handler. A second signal has no effect."""
        self.end(0 if self.came_back else -int(signum))

    def end(self, code: int) -> None:
        """End the process with a return code. Only the first call has an effect."""
        if self.returncode is None:
            self.returncode = code
            if self._on_exit is not None:
                self._on_exit(code)


class RehearsalHost(Host):
    """Runs only the launch process. All other processes are imaginary.

    :ivar closed: the object that prevents and records changes of the computer.
    """

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        self.closed = Closed()
        self.imaginary: list[ImaginaryProcess] = []
        self.came_back: set[int] = set()
        """Numbers of the processes that `respawn` started again."""
        self._commands: deque[ImaginaryProcess] = deque()
        self._nodes: deque[ImaginaryProcess] = deque()
        self._ended_names: set[str] = set()
        self._entries: dict[str, Sequence[Entry]] = {}
        self._contents: dict[str, Any] = {}

    def start_launched(self, spec: ProcessSpec, on_output: OnOutput, on_exit: OnExit) -> Any:
        """Record a process, and return an imaginary process that exists until launch stops it."""
        process = self._imagine(spec, on_exit)
        process.came_back = spec.name in self._ended_names
        if process.came_back:
            self.came_back.add(process.pid)
        (self._commands if spec.package is None else self._nodes).append(process)
        return process

    def adopt(self, process: Process) -> Process:
        """Add a program that runs in the dry run, and prevent it from making changes."""
        self.closed.enter(process)
        return super().adopt(process)

    def knows(self, spec: ProcessSpec) -> bool:
        """Return True, so that no command of this computer runs."""
        return True

    def start_command(self, spec: ProcessSpec, on_output: OnOutput, on_exit: OnExit) -> Any:
        """Run a command that the simulation has as a program or tool, because the launch may depend on its output.

        The host imitates `cat` and `echo`, which only read. Any other command seems to print nothing.

        :raises FileNotFoundError: when the command does not exist.
        """
        known = self.known_command(spec)
        if known is not None and (known.program is not None or known.tool):
            return super().start(spec, on_output, on_exit)
        if known is None and which(spec.argv[0], path=(spec.env or self.env).get('PATH')) is None:
            raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), spec.argv[0])
        code, printed, complaint = _printed(spec)
        process = self._imagine(spec, on_exit)
        if printed is None:
            self.closed.note(f'run the command {" ".join(spec.argv)}, so its output is taken to be empty')

        def end() -> None:
            for stream, text in (('stdout', printed), ('stderr', complaint)):
                if text:
                    on_output(stream, text)
            process.end(code)

        self.sim.schedule(self.sim.now_ns, end)
        return process

    def start(
        self, spec: ProcessSpec, on_output: OnOutput | None = None, on_exit: OnExit | None = None, *, index: Index | None = None
    ) -> Any:
        """Start a command for the code of a launch file. Only `ros2 pkg` and similar commands really run.

        Any other command ends immediately without output.
        """
        tool = os.path.basename(spec.argv[0])
        if tool == 'ros2' and tool in self.command_set.tools and spec.argv[1:2] and spec.argv[1] in LOOKING_UP:
            return super().start(spec, on_output, on_exit, index=index)
        self.closed.note(f'run the command {" ".join(spec.argv)}')
        process = self._imagine(spec, on_exit)
        self.sim.schedule(self.sim.now_ns, lambda: process.end(0))
        return process

    def _imagine(self, spec: ProcessSpec, on_exit: OnExit | None) -> ImaginaryProcess:
        process = ImaginaryProcess(spec, self.next_pid(), on_exit)
        self.imaginary.append(process)
        return process

    def parameter_entries(self, path: str) -> Sequence[Entry]:
        """Return the entries of a parameter file. Each file is read once, because files do not change during a dry run."""
        if path not in self._entries:
            self._entries[path] = super().parameter_entries(path)
        return self._entries[path]

    def parameter_content(self, path: str) -> Any:
        """Return the YAML content of a parameter file.

        Return None if the file cannot be read, or if it is too large when its aliases are expanded.
        """
        if path not in self._contents:
            generated: Any = self.generated_files.get(path)
            self._contents[path] = _content_of_file(path) if generated is None else generated.content
        return self._contents[path]

    def run_launch(self, main: Callable[[Process], object]) -> Process:
        """Start the process in which launch runs. Return the process."""
        spec = ProcessSpec(argv=('ros2', 'launch'), name='launch')
        return self.adopt(Process(self, spec, self.next_pid(), list(spec.argv), main))

    def end_next(self) -> bool:
        """End the next process with exit code 0. Return False if no process is left.

        Plain commands end first, then nodes, each in the order of their start. A process that `respawn` has started again
        does not end again.
        """
        for waiting in (self._commands, self._nodes):
            while waiting:
                process = waiting.popleft()
                if process.returncode is None and process.spec.name not in self._ended_names:
                    self._ended_names.add(process.spec.name)
                    process.end(0)
                    return True
        return False

    def end_all(self) -> None:
        """End all processes with exit code 0, including processes that were started again."""
        for process in list(self.imaginary):
            process.end(0)


def _printed(spec: ProcessSpec) -> tuple[int, str | None, str]:
    """Return the exit code, the output and the error output of `cat` or `echo`. Any other command has the output None."""
    name, *words = spec.argv
    if os.path.basename(name) == 'echo' and words[:1] != ['-e']:
        is_bare = words[:1] == ['-n']
        return 0, ' '.join(words[is_bare:]) + ('' if is_bare else '\n'), ''
    if os.path.basename(name) != 'cat' or not words or any(word.startswith('-') for word in words):
        return 0, None, ''
    texts = []
    for word in words:
        try:
            with open(os.path.join(spec.cwd or '', word), encoding='utf-8', errors='replace') as file:
                texts.append(file.read())
        except OSError as error:
            return 1, '', f'cat: {word}: {error.strerror}\n'
    return 0, ''.join(texts), ''


def _content_of_file(path: str) -> Any:
    import yaml
    from launch.utilities.yaml_reader import read

    try:
        with open(path, encoding='utf-8') as file:
            return read(file.read())
    except (yaml.YAMLError, ValueError, OSError):
        return None


class Notes(Tracer):
    """Stores launch's log messages with at least the level WARNING, and the output of launch files."""

    def __init__(self) -> None:
        self.logs: list[list[str]] = []
        self.stdout = ''

    def log(self, process: Any, level: int, logger: str, message: str) -> None:
        """Store a log message if it is a warning or an error."""
        if level >= WARNING:
            import logging

            self.logs.append([logging.getLevelName(level), logger, message])

    def output(self, process: Any, stream: str, text: str) -> None:
        """Store output that a launch file writes to standard output."""
        if stream == 'stdout':
            self.stdout += text


FIRST_STATE = 'unconfigured'


class ImaginedLifecycles:
    """The states that the lifecycle nodes of one plan would have."""

    def __init__(self) -> None:
        self._states: dict[Any, str] = {}

    def change(self, context: LaunchContext, node: Any, transition_id: int) -> bool:
        """Make a transition, and report both of its steps to launch, as the node's topic `transition_event` does.

        :param context: the launch context.
        :param node: the LifecycleNode action.
        :param transition_id: the number of the transition.
        :returns: False if the node's current state does not have this transition, otherwise True.
        """
        from rclpy.lifecycle.state_machine import OUTCOMES, TransitionCallbackReturn, transition_from

        state = self._states.get(node, FIRST_STATE)
        transition = transition_from(state, transition_id)
        if transition is None:
            return False
        outcome = OUTCOMES[transition.during][TransitionCallbackReturn.SUCCESS]
        self._tell(context, node, transition.label, state, transition.during)
        self._tell(context, node, outcome.label, transition.during, outcome.goal)
        self._states[node] = outcome.goal
        return True

    @staticmethod
    def _tell(context: LaunchContext, node: Any, label: str, start: str, goal: str) -> None:
        from launch_ros.events.lifecycle.state_transition import StateTransition
        from lifecycle_msgs.msg import TransitionEvent

        message: Any = TransitionEvent()
        message.transition.label, message.start_state.label, message.goal_state.label = label, start, goal
        context.emit_event_sync(StateTransition(action=node, msg=message))


TURN_LIMIT_S = 2.0
"""Seconds of processor time that the code of a launch file may take without progress; see `Watchdog`."""
MOST_INSTANTS = 2_000
MOST_STEPS = 500_000
"""Limits for a dry run: how often simulated time may advance, and how many actions may run, before a process must end."""
STEPS_BETWEEN_COLLECTIONS = 20_000
"""Steps between two garbage collections. The collector stays off otherwise, because it takes half of the time of a large plan."""


def run_to_rest(sim: Simulation) -> str | None:
    """Run the simulation until no item is left. Return an error message if the simulation does not end, otherwise None."""
    instants, now = 0, sim.now_ns
    for step in range(MOST_STEPS):
        if step % STEPS_BETWEEN_COLLECTIONS == STEPS_BETWEEN_COLLECTIONS - 1:
            gc.collect()
        if not sim.step():
            return None
        if sim.now_ns != now:
            instants, now = instants + 1, sim.now_ns
            if instants > MOST_INSTANTS:
                break
    return still_busy(sim)


def still_busy(sim: Simulation) -> str:
    """Return the error message for a launch that does not end."""
    return f'the launch file goes on without end: after {sim.elapsed_s:g} simulated seconds it still does something'


def runaway_error(error: RunawayProgram) -> dict[str, str | None]:
    """Return the error of a plan whose launch file was stopped in an endless loop. Its place is the line of the loop."""
    from traceback import walk_tb

    places = [f'{frame.f_code.co_filename}:{line}' for frame, line in walk_tb(error.__traceback__)]
    own = [place for place in places if is_students(place.rpartition(':')[0])]
    return {
        'type': 'RunawayProgramError',
        'text': 'the launch file never came to its end and was stopped',
        'help': 'look for a loop that does not end: a launch file only says what to start',
        'origin': own[-1] if own else None,
        'stage': 'load',
    }
