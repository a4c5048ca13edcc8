"""The event `TimerEvent`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .._bases import ReadOnly
from ..event import Event

if TYPE_CHECKING:
    from ..actions.timer_action import TimerAction


class TimerEvent(Event):
    """Emitted by a `TimerAction` after its period."""

    name = 'launch.events.TimerEvent'

    def __init__(self, *, timer_action: TimerAction) -> None:
        self.__timer_action = timer_action

    timer_action: ReadOnly[TimerAction] = ReadOnly('The timer.')
