"""Waiting for several things to be ready."""

from __future__ import annotations

from collections.abc import Callable


class ReadyAggregator:
    """Calls a function when `ready_fn` has been called so many times.

    :param parent_ready_fn: the function; it is called once.
    :param num_calls: how many calls it takes.
    """

    def __init__(self, parent_ready_fn: Callable[[], object], num_calls: int) -> None:
        self._parent_ready_fn = parent_ready_fn
        self._missing = num_calls

    def ready_fn(self) -> None:
        """One more thing is ready."""
        self._missing -= 1
        if self._missing == 0:
            self._parent_ready_fn()
