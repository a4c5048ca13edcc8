"""How processes of a launch test ended: `proc_info` of the tests."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from launch.events.process import ProcessExited, RunningProcessEvent

from edulaunch.sim.sync import Condition

from .util.proc_lookup import CmdArgs, NoMatchingProcessException, process_name, resolveProcesses


class ProcInfoHandler:
    """The last event of each process: ProcessExited, or ProcessStarted while it runs."""

    def __init__(self) -> None:
        self._proc_info: dict[Any, RunningProcessEvent] = {}

    def append(self, process_info: RunningProcessEvent) -> None:
        """Note an event."""
        self._proc_info[process_info.action] = process_info

    def __iter__(self) -> Iterator[RunningProcessEvent]:
        return iter(list(self._proc_info.values()))

    def __contains__(self, key: object) -> bool:
        return any(key is action or (isinstance(key, str) and key in process_name(action)) for action in self._proc_info)

    def __getitem__(self, key: Any) -> RunningProcessEvent:
        """The event of an action, or of the first process with `key` in its name. Raises KeyError when there is none."""
        if isinstance(key, str):
            for action, event in self._proc_info.items():
                if key in process_name(action):
                    return event
            raise KeyError(key)
        return self._proc_info[key]

    def processes(self) -> list[Any]:
        """The actions."""
        return list(self._proc_info)

    def process_names(self) -> list[str]:
        """The launch names, such as 'talker-1'."""
        return [process_name(action) for action in self._proc_info]


class ActiveProcInfoHandler(ProcInfoHandler):
    """For tests that run while processes run: they can wait for starts and ends, in simulated time."""

    def __init__(self) -> None:
        super().__init__()
        self._changed = Condition()

    def append(self, process_info: RunningProcessEvent) -> None:
        """Note an event, and wake who waits for one."""
        with self._changed:
            super().append(process_info)
            self._changed.notify_all()

    def assertWaitForShutdown(self, process: Any, cmd_args: CmdArgs = None, *, timeout: float = 10) -> None:
        """Wait until a process has ended.

        :param process: an action, or part of a launch name.
        :param timeout: simulated seconds.
        :raises AssertionError: when it has not ended then.
        """
        ended = self._wait(process, cmd_args, ProcessExited, timeout)
        assert ended, f"Timed out waiting for process '{_told(process)}' to finish"

    def assertWaitForStartup(self, process: Any, cmd_args: CmdArgs = None, *, timeout: float = 10) -> None:
        """Wait until a process has started (it may have ended since).

        :raises AssertionError: when it has not started after `timeout` simulated seconds; the text is ROS 2's.
        """
        started = self._wait(process, cmd_args, RunningProcessEvent, timeout)
        assert started, (
            f"Timed out waiting for process '{_told(process)}' to finish\n"
            f'  help: it has not started; started are: {", ".join(self.process_names()) or "none"}'
        )

    def _wait(self, process: Any, cmd_args: CmdArgs, event_type: type, timeout: float) -> bool:
        def has_come() -> bool:
            try:
                (action,) = resolveProcesses(self, process=process, cmd_args=cmd_args)
            except NoMatchingProcessException:
                return False
            return isinstance(self._proc_info[action], event_type)

        with self._changed:
            return bool(self._changed.wait_for(has_come, timeout))


def _told(process: Any) -> str:
    return process if isinstance(process, str) else process_name(process)
