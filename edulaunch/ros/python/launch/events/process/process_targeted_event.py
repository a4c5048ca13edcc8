"""`ProcessMatcher` and `ProcessTargetedEvent`."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ..._bases import ReadOnly
from ...event import Event

ProcessMatcher = Callable[[Any], bool]


class ProcessTargetedEvent(Event):
    """The base class of all events for certain processes.

    :param process_matcher: a function that is called with each action that has started a process. It returns whether the event
        is for that process.
    """

    name = 'launch.events.process.ProcessTargetedEvent'

    def __init__(self, *, process_matcher: ProcessMatcher) -> None:
        self.__process_matcher = process_matcher

    process_matcher: ReadOnly[ProcessMatcher] = ReadOnly('The function that decides for which processes the event is.')
