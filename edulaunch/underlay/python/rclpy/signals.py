"""What Ctrl-C and a request to terminate do to ROS 2."""
from __future__ import annotations

import signal
from enum import IntEnum

from rclpy.process_state import ProcessState, process_state


class SignalHandlerOptions(IntEnum):
    """Which signals rclpy handles."""

    ALL = 0
    SIGINT = 1
    SIGTERM = 2
    NO = 3


def install_signal_handlers(options: SignalHandlerOptions = SignalHandlerOptions.ALL) -> None:
    """From now on SIGINT shuts all contexts down and raises KeyboardInterrupt; SIGTERM shuts them down and nothing more."""
    state = process_state()
    handlers = state.process.signal_handlers
    if options in (SignalHandlerOptions.ALL, SignalHandlerOptions.SIGINT):
        handlers.setdefault(signal.SIGINT, _on_interrupt)
    if options in (SignalHandlerOptions.ALL, SignalHandlerOptions.SIGTERM):
        handlers.setdefault(signal.SIGTERM, _on_terminate)
    state.signal_options = options


def uninstall_signal_handlers() -> None:
    """Undo :func:`install_signal_handlers`."""
    state = process_state()
    handlers = state.process.signal_handlers
    for number, handler in ((signal.SIGINT, _on_interrupt), (signal.SIGTERM, _on_terminate)):
        if handlers.get(number) is handler:
            del handlers[number]
    state.signal_options = SignalHandlerOptions.NO


def get_current_signal_handlers_options() -> SignalHandlerOptions:
    """Which signals are handled now."""
    options = process_state().signal_options
    return SignalHandlerOptions.NO if options is None else SignalHandlerOptions(options)


def _on_interrupt(_: int) -> None:
    _shut_down(process_state())
    raise KeyboardInterrupt


def _on_terminate(_: int) -> None:
    _shut_down(process_state())


def _shut_down(state: ProcessState) -> None:
    for context in list(state.contexts):
        context.try_shutdown()


class SignalHandlerGuardCondition:
    """A guard condition that SIGINT triggers. Waiting ends by itself here, so nothing needs it; kept for code that makes one."""

    def __init__(self, context: object = None) -> None:
        self.context = context

    def destroy(self) -> None:
        """Forget it."""
