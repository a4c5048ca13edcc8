"""A host that starts nothing: it notes what it is asked to start, and lets each process end when told to."""

from __future__ import annotations

import os
from collections import deque
from collections.abc import Callable, Sequence
from typing import Any

from edulaunch.graph.parameter_files import Entry
from edulaunch.graph.tracer import Tracer
from edulaunch.packages import Index
from edulaunch.processes.host import Host
from edulaunch.processes.process import OnExit, OnOutput, Process
from edulaunch.processes.spec import ProcessSpec

WARNING = 30
LOOKING_UP = ('pkg', 'interface')
"""Verbs of `ros2` that only look something up."""


class ImaginaryProcess:
    """A process that does nothing but be there; a signal ends it.

    :param on_exit: told the return code.
    :ivar came_back: whether it is a process that has ended once already, and was started again.
    """

    came_back = False

    def __init__(self, spec: ProcessSpec, pid: int, on_exit: OnExit | None) -> None:
        self.spec = spec
        self.pid = pid
        self.returncode: int | None = None
        self._on_exit = on_exit

    def send_signal(self, signum: int) -> None:
        """End, as a program does that has no handler; the second end of a process is no news."""
        self.end(0 if self.came_back else -int(signum))

    def end(self, code: int) -> None:
        """End with a return code, once."""
        if self.returncode is None:
            self.returncode = code
            if self._on_exit is not None:
                self._on_exit(code)


class RehearsalHost(Host):
    """Runs the launch process itself; every other process is imaginary."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        self.imaginary: list[ImaginaryProcess] = []
        self.came_back: set[int] = set()
        """Numbers of the processes that `respawn` started again."""
        self._commands: deque[ImaginaryProcess] = deque()
        self._nodes: deque[ImaginaryProcess] = deque()
        self._ended_names: set[str] = set()
        self._entries: dict[str, Sequence[Entry]] = {}
        self._contents: dict[str, Any] = {}

    def start_launched(self, spec: ProcessSpec, on_output: OnOutput, on_exit: OnExit) -> Any:
        """Note the process; it is there at once, and stays until it is told to end."""
        process = self._imagine(spec, on_exit)
        process.came_back = spec.name in self._ended_names
        if process.came_back:
            self.came_back.add(process.pid)
        (self._commands if spec.package is None else self._nodes).append(process)
        return process

    def start_command(self, spec: ProcessSpec, on_output: OnOutput, on_exit: OnExit) -> Any:
        """Run the command: what is launched depends on what it prints."""
        return super().start(spec, on_output, on_exit)

    def start(
        self, spec: ProcessSpec, on_output: OnOutput | None = None, on_exit: OnExit | None = None, *, index: Index | None = None
    ) -> Any:
        """For the code of a launch file: `ros2 pkg` and the like run, anything else seems to end at once, without output."""
        if os.path.basename(spec.argv[0]) == 'ros2' and spec.argv[1:2] and spec.argv[1] in LOOKING_UP and self.ros2 is not None:
            return super().start(spec, on_output, on_exit, index=index)
        process = self._imagine(spec, on_exit)
        self.sim.schedule(self.sim.now_ns, lambda: process.end(0))
        return process

    def _imagine(self, spec: ProcessSpec, on_exit: OnExit | None) -> ImaginaryProcess:
        process = ImaginaryProcess(spec, self.next_pid(), on_exit)
        self.imaginary.append(process)
        return process

    def parameter_entries(self, path: str) -> Sequence[Entry]:
        """As any host; nothing changes during a dry run, so each file is read once."""
        if path not in self._entries:
            self._entries[path] = super().parameter_entries(path)
        return self._entries[path]

    def parameter_content(self, path: str) -> Any:
        """What YAML reads in a parameter file; None when it cannot be read, or is too much with its aliases replaced."""
        if path not in self._contents:
            generated: Any = self.generated_files.get(path)
            self._contents[path] = _content_of_file(path) if generated is None else generated.content
        return self._contents[path]

    def run_launch(self, main: Callable[[Process], object]) -> Process:
        """Start the process in which launch runs."""
        spec = ProcessSpec(argv=('ros2', 'launch'), name='launch')
        return self.adopt(Process(self, spec, self.next_pid(), list(spec.argv), main))

    def end_next(self) -> bool:
        """Let the next process end with code 0: plain commands first, then nodes, each in the order they
        started.

        A process that came back by `respawn` does not end again. False when none is left to end.
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
        """Let those that came back end as well."""
        for process in list(self.imaginary):
            process.end(0)


def _content_of_file(path: str) -> Any:
    import yaml
    from launch.utilities.yaml_reader import read

    try:
        with open(path, encoding='utf-8') as file:
            return read(file.read())
    except (yaml.YAMLError, ValueError, OSError):
        return None


class Notes(Tracer):
    """Keeps what launch logs from WARNING on, and what launch files print."""

    def __init__(self) -> None:
        self.logs: list[list[str]] = []
        self.stdout = ''

    def log(self, process: Any, level: int, logger: str, message: str) -> None:
        """Keep warnings and errors."""
        if level >= WARNING:
            import logging

            self.logs.append([logging.getLevelName(level), logger, message])

    def output(self, process: Any, stream: str, text: str) -> None:
        """Keep what was printed."""
        if stream == 'stdout':
            self.stdout += text
