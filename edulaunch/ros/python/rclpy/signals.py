"""The effect of Ctrl-C (SIGINT) and of SIGTERM on ROS 2."""

from __future__ import annotations

import signal
from collections.abc import Callable

from edulaunch.ros.passed_on import passed_on
from rclpy.impl.c_enum import Pybind11Enum
from rclpy.process_state import ProcessState, process_state


class SignalHandlerOptions(Pybind11Enum):
    """The signals that rclpy handles."""

    ALL = 3
    NO = 0
    SIGINT = 1
    SIGTERM = 2


def install_signal_handlers(options: SignalHandlerOptions = SignalHandlerOptions.ALL) -> None:
    """Handle signals from now on. SIGINT shuts all contexts down and raises KeyboardInterrupt. SIGTERM only shuts them down.

    If the program has set its own handler earlier, that handler is called afterwards, in place of the KeyboardInterrupt.
    """
    state = process_state()
    if options in (SignalHandlerOptions.ALL, SignalHandlerOptions.SIGINT):
        _install(state, signal.SIGINT, _raise_keyboard_interrupt)
    if options in (SignalHandlerOptions.ALL, SignalHandlerOptions.SIGTERM):
        _install(state, signal.SIGTERM, None)
    state.signal_options = options


def _install(state: ProcessState, number: int, default: Callable[[int], object] | None) -> None:
    handlers = state.process.signals.handlers
    if number in state.previous_handlers:
        return
    before = state.process.receive_real(number) or handlers.get(number)
    if before == state.process.signals.die_at_once:
        default = None  # rclpy calls the previous handler, but never a default action

    def handler(signum: int) -> None:
        from rclpy.impl.facts import note_interruption

        for context in list(state.contexts):
            note_interruption(context)
            context.rcl_end_by_signal()
        following = default if before is None or before == state.process.signals.die_at_once else before
        if following is not None:
            following(signum)

    state.previous_handlers[number] = (handler, before)
    handlers[number] = handler


def uninstall_signal_handlers() -> None:
    """Restore the handlers that :func:`install_signal_handlers` replaced."""
    state = process_state()
    handlers = state.process.signals.handlers
    for number, (handler, before) in state.previous_handlers.items():
        state.process.release_real(number)
        if handlers.get(number) is handler:
            del handlers[number]
            if before is not None:
                handlers[number] = before
    state.previous_handlers.clear()
    state.signal_options = SignalHandlerOptions.NO


def get_current_signal_handlers_options() -> SignalHandlerOptions:
    """Return the signals that rclpy handles."""
    options = process_state().signal_options
    return SignalHandlerOptions.NO if options is None else SignalHandlerOptions(options)


def _raise_keyboard_interrupt(_: int) -> None:
    raise KeyboardInterrupt


class SignalHandlerGuardCondition:
    """ROS 2's guard condition for SIGINT. Here, SIGINT ends waits without this guard condition, so it has no effect. Programs
    may still create one.
    """

    def __init__(self, context: object = None) -> None:
        self.context = context

    def destroy(self) -> None:
        """Do nothing, because the guard condition has no resources."""


__getattr__ = passed_on(__name__)
