"""The event `ExecutionComplete`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .._bases import ReadOnly
from ..event import Event

if TYPE_CHECKING:
    from ..action import Action


class ExecutionComplete(Event):
    """Emitted after an action's `execute`, or when the action's future is done. For a process, this is the end of the process."""

    name = 'launch.events.ExecutionComplete'

    def __init__(self, *, action: Action) -> None:
        self.__action = action

    action: ReadOnly[Action] = ReadOnly('The action.')
