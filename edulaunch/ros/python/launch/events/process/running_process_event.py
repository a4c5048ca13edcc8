"""The event `RunningProcessEvent`."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from ..._bases import ReadOnly
from ...event import Event

if TYPE_CHECKING:
    from ...actions.execute_local import ExecuteLocal


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
