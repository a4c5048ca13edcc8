"""Handles signals as events of launch's loop."""

from __future__ import annotations

import signal
import threading
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from edulaunch.engine.processes.spec import Signals

from .._engine import is_plain_script, running_process

if TYPE_CHECKING:
    import asyncio
    from types import FrameType, TracebackType

SignalHandler = Callable[[int], object]


class AsyncSafeSignalManager:
    """Handles signals of the running process as callbacks of an asyncio loop.

    The manager is active inside a `with` block, whose end restores the previous handlers. As in upstream, a plain script
    receives the real signals for which Python has a handler. That handler is called as well. If it raises KeyboardInterrupt, it
    is called only when the signal arrives again before the loop has handled it.
    """

    def __init__(self, loop: asyncio.AbstractEventLoop) -> None:
        self.__loop = loop
        self.__process = running_process()
        self.__handlers: dict[int, SignalHandler] = {}
        self.__is_active = False
        self.__before: dict[int, Any] = {}
        self.__real_before: dict[int, Callable[[int, FrameType | None], object]] = {}
        self.__waiting: list[int] = []

    def __enter__(self) -> AsyncSafeSignalManager:
        self.__is_active = True
        for number in self.__handlers:
            self.__install(number)
        return self

    def __exit__(
        self, exc_type: type[BaseException] | None, exc_value: BaseException | None, traceback: TracebackType | None
    ) -> None:
        self.__is_active = False
        for number in list(self.__before):
            self.__remove(number)

    def handle(self, signum: int, handler: SignalHandler | None) -> SignalHandler | None:
        """Set `handler(signum)` as the handler of this signal. None removes the handler. Return the previous handler.

        :raises ValueError: for an invalid signal number, and for a handler that cannot be called.
        """
        number = Signals(signum)
        if handler is not None and not callable(handler):
            raise ValueError('signal handler must be a callable')
        before = self.__handlers.pop(number, None)
        if handler is None:
            self.__remove(number)
        else:
            self.__handlers[number] = handler
            if self.__is_active:
                self.__install(number)
        return before

    def __install(self, number: int) -> None:
        if number in self.__before:
            return
        installed = self.__process.signals.handlers
        self.__before[number] = installed.get(number)
        installed[number] = self.__take
        if is_plain_script() and threading.current_thread() is threading.main_thread():
            before = signal.getsignal(number)
            if callable(before) and getattr(before, '__self__', None) is not self.__process:  # a process passes its signals on
                self.__real_before[number] = before
                signal.signal(number, self.__take_real)

    def __remove(self, number: int) -> None:
        if number not in self.__before:
            return
        installed = self.__process.signals.handlers
        before = self.__before.pop(number)
        installed.pop(number, None)
        if before is not None:
            installed[number] = before
        real = self.__real_before.pop(number, None)
        if real is not None:
            signal.signal(number, real)

    def __take_real(self, number: int, frame: FrameType | None) -> None:
        before = self.__real_before[number]
        if before is not signal.default_int_handler or number in self.__waiting:
            before(number, frame)
        self.__take(number)

    def __take(self, number: int) -> None:
        self.__waiting.append(number)
        self.__loop.call_soon_threadsafe(self.__deliver, number)

    def __deliver(self, number: int) -> None:
        self.__waiting.remove(number)
        handler = self.__handlers.get(number)
        if handler is not None:
            handler(number)
