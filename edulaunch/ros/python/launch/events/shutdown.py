"""The event `Shutdown`."""

from __future__ import annotations

from .._bases import ReadOnly
from ..event import Event


class Shutdown(Event):
    """Ends the whole launch. Processes receive signals, timers are cancelled, and no new process starts.

    :param reason: the reason that the log and `LocalSubstitution('event.reason')` show.
    :param due_to_sigint: whether the user pressed Ctrl-C. In a terminal, the processes have then already received SIGINT.
    """

    name = 'launch.events.Shutdown'

    def __init__(self, *, reason: str = 'reason not given', due_to_sigint: bool = False) -> None:
        self.__reason = reason
        self.__due_to_sigint = due_to_sigint

    reason: ReadOnly[str] = ReadOnly('The reason for the shutdown.')
    due_to_sigint: ReadOnly[bool] = ReadOnly('Whether the user pressed Ctrl-C.')
