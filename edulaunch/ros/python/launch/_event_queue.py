"""The queue of events that launch has not handled yet."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import Any


class EventQueue(asyncio.Queue):  # type: ignore[type-arg]
    """An asyncio queue that calls a function when an event is added.

    :ivar on_put: the function, called without arguments after each put. None means no call.
    """

    on_put: Callable[[], object] | None = None

    def _put(self, item: Any) -> None:
        super()._put(item)
        if self.on_put is not None:
            self.on_put()
