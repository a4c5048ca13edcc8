"""The default context, and what belongs to a whole program."""

from __future__ import annotations

from rclpy.constants import S_TO_NS
from rclpy.context import Context, parse_or_raise
from rclpy.process_state import process_state


def get_default_context(*, shutting_down: bool = False) -> Context:
    """The context that is used when none is named. After a shutdown the next one is new, so ROS 2 can be initialised again."""
    state = process_state()
    context: Context | None = state.default_context
    if context is None:
        context = state.default_context = Context()
    if shutting_down:
        state.default_context = None
    return context


def ok(*, context: Context | None = None) -> bool:
    """Return whether ROS 2 is between init and shutdown."""
    return (context or get_default_context()).ok()


def shutdown(*, context: Context | None = None) -> None:
    """Shut a context down. Raises RuntimeError when it was never initialised."""
    (context or get_default_context(shutting_down=True)).shutdown()


def try_shutdown(*, context: Context | None = None) -> None:
    """Shut a context down if that was not done yet; never raises."""
    (context or get_default_context(shutting_down=True)).try_shutdown()


def get_rmw_implementation_identifier() -> str:
    """Return the name of the middleware."""
    return process_state().process.env.get('RMW_IMPLEMENTATION') or 'rmw_fastrtps_cpp'


def get_available_rmw_implementations() -> set[str]:
    """Return the names of all middlewares that could be used."""
    return {get_rmw_implementation_identifier()}


def remove_ros_args(args: list[str] | None = None) -> list[str]:
    """Return a command line (None: the program's own) without its `--ros-args` sections and remap rules.

    :raises RCLInvalidROSArgsError, UnknownROSArgsError: for arguments after `--ros-args` that cannot be understood.
    """
    return parse_or_raise(process_state().process.argv if args is None else args).others


def timeout_sec_to_nsec(timeout_sec: float | None) -> int:
    """Return a timeout in the form of the wait set: -1 (wait forever) for None or a negative number, 0 (do not wait) for 0."""
    if timeout_sec is None or timeout_sec < 0:
        return -1
    return int(float(timeout_sec) * S_TO_NS)
