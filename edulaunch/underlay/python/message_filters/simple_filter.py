"""The base of all filters: something that gives messages to callbacks."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any


class SimpleFilter:
    """Keeps callbacks; `signalMessage` calls them in the order in which they were registered."""

    def __init__(self) -> None:
        self.callbacks: dict[int, tuple[Callable[..., Any], tuple[Any, ...]]] = {}

    def registerCallback(self, cb: Callable[..., Any], *args: Any) -> int:
        """Call `cb(message ..., *args)` for what passes the filter; gives the number of the registration."""
        number = len(self.callbacks)
        self.callbacks[number] = (cb, args)
        return number

    def signalMessage(self, *msg: Any) -> None:
        """Let messages pass: one for a filter of one topic, one of each topic for a synchronizer."""
        for callback, args in list(self.callbacks.values()):
            callback(*msg, *args)
