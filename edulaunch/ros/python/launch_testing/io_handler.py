"""What processes of a launch test wrote and how they ended: `proc_output` and `proc_info` of the tests."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any, Generic, TypeVar

from launch._lazy import has_ros_paths
from launch.events.process.process_exited import ProcessExited
from launch.events.process.process_io import ProcessIO
from launch.events.process.running_process_event import RunningProcessEvent

from edulaunch.engine.sim.sync import Condition

from .asserts import assertInStream
from .util import CmdArgs, NoMatchingProcessException, process_name, resolveProcesses

Noted = TypeVar('Noted')


class _ByProcess(Generic[Noted]):
    """What was noted of each process, by its action or by part of its launch name."""

    def __init__(self) -> None:
        self._noted: dict[Any, Noted] = {}
        self._changed = Condition()

    def __contains__(self, key: object) -> bool:
        return any(key is action or (isinstance(key, str) and key in process_name(action)) for action in self._noted)

    def __getitem__(self, key: Any) -> Noted:
        """What was noted of an action, or of the first process with `key` in its name. Raises KeyError when there is none."""
        if isinstance(key, str):
            key = next((action for action in self._noted if key in process_name(action)), key)
        return self._noted[key]

    def processes(self) -> list[Any]:
        """The actions."""
        return list(self._noted)

    def process_names(self) -> list[str]:
        """The launch names, such as 'talker-1'."""
        return [process_name(action) for action in self._noted]

    def _wait(self, has_come: Callable[[], bool], timeout: float) -> bool:
        with self._changed:
            return bool(self._changed.wait_for(has_come, timeout))

    def _tell(self) -> None:
        with self._changed:
            self._changed.notify_all()


class IoHandler(_ByProcess[list[ProcessIO]]):
    """Everything that was written, in order and by process."""

    def __init__(self) -> None:
        super().__init__()
        self._sequence: list[ProcessIO] = []

    def append(self, process_io: ProcessIO) -> None:
        """Note a piece of output, and wake who waits for some."""
        self._sequence.append(process_io)
        self._noted.setdefault(process_io.action, []).append(process_io)
        self._tell()

    def track(self, action: Any) -> None:
        """Note that a process has started; it may never write anything."""
        self._noted.setdefault(action, [])

    def __iter__(self) -> Iterator[ProcessIO]:
        return iter(list(self._sequence))


class ActiveIoHandler(IoHandler):
    """For tests that run while processes run: they can wait for output, in simulated time."""

    def waitFor(
        self,
        expected_output: Any,
        process: Any = None,
        cmd_args: CmdArgs = None,
        *,
        timeout: float = 10,
        stream: str = 'stderr',
        **options: Any,
    ) -> bool:
        """Wait for output; False when it has not come after `timeout` simulated seconds.

        :param expected_output: a text, a compiled regular expression, or a list of them that must come in this order.
        :param process: an action, or part of a launch name; None: any process.
        :param cmd_args: narrows a name down, see :func:`launch_testing.util.resolveProcesses`.
        :param stream: 'stdout' or 'stderr'; as in ROS 2 the default is stderr, where nodes log.
        :param options: those of :func:`launch_testing.asserts.assertInStream`.
        """

        def has_come() -> bool:
            try:
                assertInStream(self, expected_output, process, cmd_args, stream=stream, **options)
            except (AssertionError, NoMatchingProcessException):
                return False
            return True

        return self._wait(has_come, timeout)

    def assertWaitFor(
        self,
        expected_output: Any,
        process: Any = None,
        cmd_args: CmdArgs = None,
        *,
        timeout: float = 10,
        stream: str = 'stderr',
        **options: Any,
    ) -> None:
        """As :meth:`waitFor`.

        :raises AssertionError: when the output has not come in time.
        """
        if not self.waitFor(expected_output, process, cmd_args, timeout=timeout, stream=stream, **options):
            raise AssertionError(f'Waiting for output timed out\n  help: {self._advice(expected_output, stream, timeout)}')

    def _advice(self, expected_output: Any, stream: str, timeout: float) -> str:
        other = 'stdout' if stream == 'stderr' else 'stderr'
        if self.waitFor(expected_output, timeout=0, stream=other, strict_proc_matching=False):
            return f"{expected_output!r} was written to {other}; say stream='{other}'"
        pieces = [piece for piece in self if piece.from_stdout == (stream == 'stdout')]
        if not pieces:
            return f'nothing was written to {stream} within {timeout} s by: {", ".join(self.process_names()) or "any process"}'
        last = pieces[-1].text.decode(errors='replace').strip().split('\n')[-1]
        return f'{expected_output!r} did not come on {stream} within {timeout} s; the last line there was {last!r}'


class ProcInfoHandler(_ByProcess[RunningProcessEvent]):
    """The last event of each process: ProcessExited, or ProcessStarted while it runs."""

    def append(self, process_info: RunningProcessEvent) -> None:
        """Note an event, and wake who waits for one."""
        self._noted[process_info.action] = process_info
        self._tell()

    def __iter__(self) -> Iterator[RunningProcessEvent]:
        return iter(list(self._noted.values()))


class ActiveProcInfoHandler(ProcInfoHandler):
    """For tests that run while processes run: they can wait for starts and ends, in simulated time."""

    def assertWaitForShutdown(self, process: Any, cmd_args: CmdArgs = None, *, timeout: float = 10) -> None:
        """Wait until a process has ended.

        :param process: an action, or part of a launch name.
        :param timeout: simulated seconds.
        :raises AssertionError: when it has not ended then.
        """
        self._wait_for_event(ProcessExited, process, cmd_args, timeout)

    def assertWaitForStartup(self, process: Any, cmd_args: CmdArgs = None, *, timeout: float = 10) -> None:
        """Wait until a process has started (it may have ended since).

        :raises AssertionError: when it has not started after `timeout` simulated seconds; the text is ROS 2's.
        """
        self._wait_for_event(
            RunningProcessEvent,
            process,
            cmd_args,
            timeout,
            lambda: f'\n  help: it has not started; started are: {", ".join(self.process_names()) or "none"}',
        )

    def _wait_for_event(
        self, event_type: type, process: Any, cmd_args: CmdArgs, timeout: float, help: Callable[[], str] = str
    ) -> None:
        def has_come() -> bool:
            try:
                (action,) = resolveProcesses(self, process=process, cmd_args=cmd_args)
            except NoMatchingProcessException:
                return False
            return isinstance(self._noted[action], event_type)

        if not self._wait(has_come, timeout):
            name = process if isinstance(process, str) else process_name(process)
            raise AssertionError(f"Timed out waiting for process '{name}' to finish{help()}")


has_ros_paths(__name__)
