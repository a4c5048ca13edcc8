"""The event `RunningProcessEvent`."""

from __future__ import annotations

from collections.abc import Mapping

from ..._bases import ReadOnly
from ...event import Event
from .process_action import ProcessAction


class RunningProcessEvent(Event):
    """The base class of all events that come from a process."""

    name = 'launch.events.process.RunningProcessEvent'

    def __init__(
        self, *, action: ProcessAction, name: str, cmd: list[str], cwd: str | None, env: Mapping[str, str] | None, pid: int
    ) -> None:
        self.__action = action
        self.__name = name
        self.__cmd = cmd
        self.__cwd = cwd
        self.__env = env
        self.__pid = pid

    action: ReadOnly[ProcessAction] = ReadOnly('The action that started the process.')

    execute_process_action: ReadOnly[ProcessAction] = ReadOnly('The deprecated name of `action`.', '__action')

    process_name: ReadOnly[str] = ReadOnly("The unique name, such as 'talker-1'.", '__name')

    cmd: ReadOnly[list[str]] = ReadOnly('The command line.')
    cwd: ReadOnly[str | None] = ReadOnly('The working directory; None means that of launch.')
    env: ReadOnly[Mapping[str, str] | None] = ReadOnly('The environment.')
    pid: ReadOnly[int] = ReadOnly('The process ID.')
