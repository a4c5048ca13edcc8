"""The event `Shutdown`."""

from __future__ import annotations

from .._bases import ReadOnly
from ..event import Event


class Shutdown(Event):
    """Ends the whole launch. Processes receive signals, timers are cancelled, and no new process starts.

    :param reason: for people, and for `LocalSubstitution('event.reason')`.
    :param due_to_sigint: the user pressed Ctrl-C, so a terminal has already signalled the processes.
    """

    name = 'launch.events.Shutdown'

    def __init__(self, *, reason: str = 'reason not given', due_to_sigint: bool = False) -> None:
        self.__reason = reason
        self.__due_to_sigint = due_to_sigint

    reason: ReadOnly[str] = ReadOnly('Why.')
    due_to_sigint: ReadOnly[bool] = ReadOnly('Whether ctrl-c was pressed.')
