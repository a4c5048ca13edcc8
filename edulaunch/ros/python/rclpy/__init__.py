"""The ROS 2 client library for Python in the simulation. The names, defaults and errors are those of ROS 2 Jazzy."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from edulaunch.ros.passed_on import passed_on
from rclpy.context import Context
from rclpy.impl.refusals import check_executor
from rclpy.parameter import Parameter
from rclpy.process_state import process_state
from rclpy.signals import SignalHandlerOptions, install_signal_handlers, uninstall_signal_handlers
from rclpy.utilities import (
    get_available_rmw_implementations,
    get_default_context,
    get_rmw_implementation_identifier,
    ok,
    timeout_sec_to_nsec,
)
from rclpy.utilities import shutdown as _shutdown
from rclpy.utilities import try_shutdown as _try_shutdown

if TYPE_CHECKING:
    from rclpy.executors import Executor
    from rclpy.node import Node
    from rclpy.task import Future

__all__ = [
    'Context',
    'Parameter',
    'SignalHandlerOptions',
    'create_node',
    'get_available_rmw_implementations',
    'get_default_context',
    'get_global_executor',
    'get_rmw_implementation_identifier',
    'init',
    'ok',
    'shutdown',
    'spin',
    'spin_once',
    'spin_until_future_complete',
    'timeout_sec_to_nsec',
    'try_shutdown',
]


def init(
    *,
    args: list[str] | None = None,
    context: Context | None = None,
    domain_id: int | None = None,
    signal_handler_options: SignalHandlerOptions | None = None,
) -> None:
    """Initialise ROS 2 for this program or context.

    :param args: the command-line arguments; None means the arguments of the program.
    :param signal_handler_options: the signals that shut ROS 2 down. By default, the default context handles all of them, and
        any other context handles no signals.
    :raises RuntimeError: when the context is already initialised.
    """
    if signal_handler_options is None:
        signal_handler_options = SignalHandlerOptions.ALL if context is None else SignalHandlerOptions.NO
    install_signal_handlers(signal_handler_options)
    (context or get_default_context()).init(args, domain_id=domain_id)


def get_global_executor() -> Executor:
    """Return the program's single-threaded executor, which is used if a call names no executor. Create it on first use."""
    state = process_state()
    executor: Executor | None = state.global_executor
    if executor is None:
        from rclpy.executors import SingleThreadedExecutor

        executor = state.global_executor = SingleThreadedExecutor()
    return executor


def shutdown(*, context: Context | None = None, uninstall_handlers: bool | None = None) -> None:
    """Shut ROS 2 down.

    :raises RuntimeError: when ROS 2 was never initialised.
    :raises RCLError: when Ctrl-C has already shut ROS 2 down. In this case, `try_shutdown()` does nothing.
    """
    _end_global_executor()
    _shutdown(context=context)
    if uninstall_handlers or (uninstall_handlers is None and context is None):
        uninstall_signal_handlers()


def try_shutdown(*, context: Context | None = None) -> None:
    """Shut ROS 2 down unless it is already shut down. Never raise an exception. As in Jazzy, signal handlers stay installed."""
    _end_global_executor()
    _try_shutdown(context=context)


def _end_global_executor() -> None:
    state = process_state()
    if state.global_executor is not None:
        state.global_executor.shutdown()
        state.global_executor = None


def create_node(
    node_name: str,
    *,
    context: Context | None = None,
    cli_args: list[str] | None = None,
    namespace: str | None = None,
    use_global_arguments: bool = True,
    enable_rosout: bool = True,
    start_parameter_services: bool = True,
    parameter_overrides: Iterable[Parameter] | None = None,
    allow_undeclared_parameters: bool = False,
    automatically_declare_parameters_from_overrides: bool = False,
    enable_logger_service: bool = False,
) -> Node:
    """Create a node. The arguments are those of :class:`rclpy.node.Node`."""
    from rclpy.node import Node

    return Node(
        node_name,
        context=context,
        cli_args=cli_args,
        namespace=namespace,
        use_global_arguments=use_global_arguments,
        enable_rosout=enable_rosout,
        start_parameter_services=start_parameter_services,
        parameter_overrides=None if parameter_overrides is None else list(parameter_overrides),
        allow_undeclared_parameters=allow_undeclared_parameters,
        automatically_declare_parameters_from_overrides=automatically_declare_parameters_from_overrides,
        enable_logger_service=enable_logger_service,
    )


def spin_once(node: Node, *, executor: Executor | None = None, timeout_sec: float | None = None) -> None:
    """Execute one callback of the node.

    :param timeout_sec: the longest wait in simulated seconds. None means no limit, and 0 means no wait.
    """
    executor = _spinning_executor(executor, node, 'spin_once')
    added = executor.add_node(node)
    try:
        executor.spin_once(timeout_sec=timeout_sec)
    finally:
        if added:
            executor.remove_node(node)


def spin(node: Node, executor: Executor | None = None) -> None:
    """Execute the node's callbacks until ROS 2 is shut down.

    :raises KeyboardInterrupt: on Ctrl-C.
    :raises rclpy.executors.ExternalShutdownException: when a signal shuts ROS 2 down while no callback is running.
    """
    executor = _spinning_executor(executor, node, 'spin')
    executor.add_node(node)
    try:
        executor.spin()
    finally:
        executor.remove_node(node)


def spin_until_future_complete(
    node: Node, future: Future, executor: Executor | None = None, timeout_sec: float | None = None
) -> None:
    """Execute the node's callbacks until the future is done. Check `future.done()` afterwards.

    :param timeout_sec: the longest wait in simulated seconds; None means no limit.
    """
    executor = _spinning_executor(executor, node, 'spin_until_future_complete', None if timeout_sec is not None else future)
    added = executor.add_node(node)
    try:
        from rclpy.task import source_of

        source = source_of(future)
        if timeout_sec is None and source is not None and source.ready_list.executor is None:
            from rclpy.impl.facts import note_foreign_future

            note_foreign_future(node, source)
        executor.spin_until_future_complete(future, timeout_sec)
    finally:
        if added:
            executor.remove_node(node)


def _spinning_executor(executor: Executor | None, node: Node, function: str, future: Future | None = None) -> Executor:
    """Return the executor to spin.

    If the call is made inside a callback of that executor, or of another executor that has the node, record the call once.

    :param future: the future that the caller waits for without a timeout.
    """
    if executor is None:
        executor = get_global_executor()
    elif not hasattr(executor, 'spinner'):
        check_executor(executor, 'remove_node' if function == 'spin' else 'add_node')
    if executor.spinner is not None and executor.rcl_note_nested_spin():
        from rclpy.impl.facts import note_spin, note_wait
        from rclpy.task import source_of

        source = None if future is None or future.rcl_ended else source_of(future)
        if source is not None and not source.callback_group.can_execute(source):
            note_wait(function, source)
        else:
            note_spin(function, node, executor)
    elif executor.spinner is None:
        core = getattr(node, '_rclpy', None)
        other = None if core is None else core.executor
        if other is not None and other is not executor and other.spinner is not None and other.rcl_note_nested_spin():
            from rclpy.impl.facts import note_lost_node

            note_lost_node(function, node, other)
    return executor


__getattr__ = passed_on(__name__)
