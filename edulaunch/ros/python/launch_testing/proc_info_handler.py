"""The starts and ends of the processes of a launch test, which tests receive as `proc_info`."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from launch.events.process.process_exited import ProcessExited
from launch.events.process.running_process_event import RunningProcessEvent

from ._by_process import _ByProcess
from .util.proc_lookup import CmdArgs, NoMatchingProcessException, process_name, resolveProcesses


class ProcInfoHandler(_ByProcess[RunningProcessEvent]):
    """The last event of each process: ProcessStarted while the process runs, and then ProcessExited."""

    def append(self, process_info: RunningProcessEvent) -> None:
        """Record an event, and wake the tasks that wait for an event."""
        self._recorded[process_info.action] = process_info
        self._tell()

    def __iter__(self) -> Iterator[RunningProcessEvent]:
        return iter(list(self._recorded.values()))


class ActiveProcInfoHandler(ProcInfoHandler):
    """The process events, for tests that run at the same time as the processes. Tests can wait for starts and ends in simulated
    time.
    """

    def assertWaitForShutdown(self, process: Any, cmd_args: CmdArgs = None, *, timeout: float = 10) -> None:
        """Wait until a process has ended.

        :param process: an action, or part of a launch name.
        :param timeout: the maximum time in simulated seconds.
        :raises AssertionError: when the process has not ended after that time.
        """
        self._wait_for_event(ProcessExited, process, cmd_args, timeout)

    def assertWaitForStartup(self, process: Any, cmd_args: CmdArgs = None, *, timeout: float = 10) -> None:
        """Wait until a process has started. The process may already have ended.

        :raises AssertionError: when the process has not started after `timeout` simulated seconds. The message is that of ROS 2.
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
            return isinstance(self._recorded[action], event_type)

        if not self._wait(has_come, timeout):
            name = process if isinstance(process, str) else process_name(process)
            raise AssertionError(f"Timed out waiting for process '{name}' to finish{help()}")
