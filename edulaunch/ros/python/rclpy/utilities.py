"""The default context, and functions for a whole program."""

from __future__ import annotations

from rclpy.constants import S_TO_NS
from rclpy.context import Context, parse_or_raise
from rclpy.process_state import process_state


def get_default_context(*, shutting_down: bool = False) -> Context:
    """Return the context that is used if a call names no context.

    After a shutdown, the next call returns a new context, so that the program can initialise ROS 2 again.
    """
    state = process_state()
    context: Context | None = state.default_context
    if context is None:
        context = state.default_context = Context()
    if shutting_down:
        state.default_context = None
    return context


def ok(*, context: Context | None = None) -> bool:
    """Return whether ROS 2 is initialised and not shut down."""
    return (context or get_default_context()).ok()


def shutdown(*, context: Context | None = None) -> None:
    """Shut a context down. Raise RuntimeError if the context was never initialised."""
    (context or get_default_context(shutting_down=True)).shutdown()


def try_shutdown(*, context: Context | None = None) -> None:
    """Shut a context down unless it is already shut down. Never raise an exception."""
    (context or get_default_context(shutting_down=True)).try_shutdown()


def get_rmw_implementation_identifier() -> str:
    """Return the name of the middleware."""
    return process_state().process.env.get('RMW_IMPLEMENTATION') or 'rmw_fastrtps_cpp'


def get_available_rmw_implementations() -> set[str]:
    """Return the names of all available middlewares."""
    return {get_rmw_implementation_identifier()}


def remove_ros_args(args: list[str] | None = None) -> list[str]:
    """Return a command line without its `--ros-args` sections and remapping rules.

    :param args: the command line; None means the command line of the program.
    :raises RCLInvalidROSArgsError, UnknownROSArgsError: for invalid or unknown arguments after `--ros-args`.
    """
    return parse_or_raise(process_state().process.argv if args is None else args).others


def timeout_sec_to_nsec(timeout_sec: float | None) -> int:
    """Return a timeout in nanoseconds. None or a negative number becomes -1 (wait without limit), and 0 stays 0 (do not wait)."""
    if timeout_sec is None or timeout_sec < 0:
        return -1
    return int(float(timeout_sec) * S_TO_NS)
