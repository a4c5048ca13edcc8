"""Events of processes."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from .._bases import ReadOnly
from .._lazy import has_ros_paths
from . import Event

if TYPE_CHECKING:
    from edulaunch.engine.processes.spec import Signals

    from ..actions.execute_local import ExecuteLocal


class RunningProcessEvent(Event):
    """Base of all events that come from a process."""

    name = 'launch.events.process.RunningProcessEvent'

    def __init__(
        self, *, action: ExecuteLocal, name: str, cmd: list[str], cwd: str | None, env: Mapping[str, str] | None, pid: int
    ) -> None:
        self.__action = action
        self.__name = name
        self.__cmd = cmd
        self.__cwd = cwd
        self.__env = env
        self.__pid = pid

    action: ReadOnly[ExecuteLocal] = ReadOnly('The action that started the process.')

    execute_process_action: ReadOnly[ExecuteLocal] = ReadOnly('The same, by an older name.', '__action')

    process_name: ReadOnly[str] = ReadOnly("The unique name, such as 'talker-1'.", '__name')

    cmd: ReadOnly[list[str]] = ReadOnly('The command line.')
    cwd: ReadOnly[str | None] = ReadOnly("The working directory, None for launch's own.")
    env: ReadOnly[Mapping[str, str] | None] = ReadOnly('The environment.')
    pid: ReadOnly[int] = ReadOnly('The process number.')


ProcessMatcher = Callable[['ExecuteLocal'], bool]


class ProcessTargetedEvent(Event):
    """Base of all events that are meant for some processes.

    :param process_matcher: decides for which; called with each action that has started a process.
    """

    name = 'launch.events.process.ProcessTargetedEvent'

    def __init__(self, *, process_matcher: ProcessMatcher) -> None:
        self.__process_matcher = process_matcher

    process_matcher: ReadOnly[ProcessMatcher] = ReadOnly('Decides which processes are meant.')


def matches_pid(pid: int) -> ProcessMatcher:
    """The process with this number."""
    return lambda action: action.process_details is not None and action.process_details['pid'] == pid


def matches_name(name: str) -> ProcessMatcher:
    """The process with this unique name, such as 'talker-1'."""
    return lambda action: action.process_details is not None and action.process_details['name'] == name


def matches_executable(executable: str) -> ProcessMatcher:
    """Processes whose program's path ends with this."""
    return lambda action: action.process_details is not None and action.process_details['cmd'][0].endswith(executable)


class ProcessStarted(RunningProcessEvent):
    """Emitted when a process has been started."""

    name = 'launch.events.process.ProcessStarted'


class ProcessIO(RunningProcessEvent):
    """Something went over one of the streams of a process.

    :param text: the bytes, which need not be whole lines.
    :param fd: 0 for stdin, 1 for stdout, 2 for stderr.
    """

    name = 'launch.events.process.ProcessIO'

    def __init__(self, *, text: bytes, fd: int, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__text = text
        self.__fd = fd

    text: ReadOnly[bytes] = ReadOnly('The bytes.')

    @property
    def from_stdin(self) -> bool:
        """Whether the process is to read it."""
        return self.__fd == 0

    @property
    def from_stdout(self) -> bool:
        """Whether it came from the standard output."""
        return self.__fd == 1

    @property
    def from_stderr(self) -> bool:
        """Whether it came from the standard error."""
        return self.__fd == 2


class ProcessStdin(ProcessIO):
    """A process is to read text on its standard input."""

    name = 'launch.events.process.ProcessStdin'

    def __init__(self, *, text: bytes, **kwargs: Any) -> None:
        super().__init__(text=text, fd=0, **kwargs)


class ProcessStdout(ProcessIO):
    """A process has written to its standard output."""

    name = 'launch.events.process.ProcessStdout'

    def __init__(self, *, text: bytes, **kwargs: Any) -> None:
        super().__init__(text=text, fd=1, **kwargs)


class ProcessStderr(ProcessIO):
    """A process has written to its standard error."""

    name = 'launch.events.process.ProcessStderr'

    def __init__(self, *, text: bytes, **kwargs: Any) -> None:
        super().__init__(text=text, fd=2, **kwargs)


class ProcessExited(RunningProcessEvent):
    """Emitted when a process has ended.

    :param returncode: the exit code; negative when a signal ended the process.
    """

    name = 'launch.events.process.ProcessExited'

    def __init__(self, *, returncode: int, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__returncode = returncode

    returncode: ReadOnly[int] = ReadOnly('The exit code.')


class SignalProcess(ProcessTargetedEvent):
    """Sends a signal to processes.

    :param signal_number: a `signal.Signals`, or its name such as 'SIGUSR1'.
    """

    name = 'launch.events.process.SignalProcess'

    def __init__(self, *, signal_number: str | Signals, process_matcher: ProcessMatcher) -> None:
        super().__init__(process_matcher=process_matcher)
        from edulaunch.engine.processes.spec import Signals

        self.__signal = Signals[signal_number] if isinstance(signal_number, str) else Signals(signal_number)

    signal: ReadOnly[Signals] = ReadOnly('The signal.')

    signal_name: ReadOnly[str] = ReadOnly('Its name.', '__signal.name')


class ShutdownProcess(ProcessTargetedEvent):
    """Asks processes to end: SIGINT first, SIGTERM and SIGKILL when that does not help."""

    name = 'launch.events.process.ShutdownProcess'


has_ros_paths(
    __name__,
    'ProcessExited ProcessIO ProcessStarted ProcessStderr ProcessStdin ProcessStdout ProcessTargetedEvent RunningProcessEvent '
    'ShutdownProcess SignalProcess matches_executable=process_matchers matches_name=process_matchers '
    'matches_pid=process_matchers',
)
