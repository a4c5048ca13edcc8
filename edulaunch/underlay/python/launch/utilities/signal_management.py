"""Signals as events of launch's loop."""
from __future__ import annotations

import signal
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from .._engine import running_process

if TYPE_CHECKING:
    import asyncio
    from types import TracebackType

SignalHandler = Callable[[int], object]


class AsyncSafeSignalManager:
    """Handles signals that the running process gets, as callbacks of an asyncio loop.

    As upstream it is used in a `with` block; afterwards the handlers are as before.
    """

    def __init__(self, loop: asyncio.AbstractEventLoop) -> None:
        self.__loop = loop
        self.__process = running_process()
        self.__handlers: dict[int, SignalHandler | None] = {}
        self.__before: dict[int, Any] = {}

    def __enter__(self) -> AsyncSafeSignalManager:
        return self

    def __exit__(self, exc_type: type[BaseException] | None, exc_value: BaseException | None,
                 traceback: TracebackType | None) -> None:
        installed = self.__process.signal_handlers
        for signum, before in self.__before.items():
            installed.pop(signum, None)
            if before is not None:
                installed[signum] = before
        self.__before.clear()
        self.__handlers.clear()

    def handle(self, signum: int, handler: SignalHandler | None) -> SignalHandler | None:
        """Let `handler(signum)` handle this signal (None: no longer); returns the handler before it.

        :raises ValueError: for a number that is no signal.
        """
        number = int(signal.Signals(signum))
        before = self.__handlers.get(number)
        installed = self.__process.signal_handlers
        if number not in self.__before:
            self.__before[number] = installed.get(number)
        self.__handlers[number] = handler
        if handler is None:
            installed.pop(number, None)
        else:
            installed[number] = lambda received: self.__loop.call_soon_threadsafe(handler, received)
        return before
