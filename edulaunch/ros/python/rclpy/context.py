"""The state of ROS 2 in a program, from init to shutdown."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any

from edulaunch.engine.facts import with_facts, with_facts_of
from edulaunch.engine.graph.names import namespace_problem
from edulaunch.engine.graph.ros_arguments import RosArguments, RosArgumentsError, parse_ros_arguments
from edulaunch.engine.processes.current import current_process
from edulaunch.engine.sim.task import Task, current_task
from rclpy._rclpy_pybind11 import RCLError, RCLInvalidROSArgsError, UnknownROSArgsError
from rclpy.impl.entity import Handle
from rclpy.process_state import process_state

if TYPE_CHECKING:
    from rclpy.impl.protocols import ExecutorProtocol, NodeProtocol


class Context:
    """The arguments and the state that nodes share. A context is initialised and shut down only once.

    A context can be used as a context manager, which initialises it and shuts it down.
    """

    def __init__(self) -> None:
        self.alive = False
        self.used = False
        self.ended_by_signal = False
        self._domain_id = 0
        self.arguments = RosArguments()
        self._callbacks: list[Callable[[], object]] = []
        self.executors: list[ExecutorProtocol] = []
        self.parked: list[Task] = []
        self._nodes: list[NodeProtocol] = []

    @property
    def handle(self) -> Handle:
        """The object that owns the context."""
        return Handle(self)

    def init(self, args: list[str] | None = None, *, initialize_logging: bool = True, domain_id: int | None = None) -> None:
        """Initialise the context.

        :param args: the command-line arguments; None means the arguments of the program.
        :raises RuntimeError: when called a second time.
        :raises UnknownROSArgsError: for unknown arguments after `--ros-args`.
        """
        if self.used:
            raise RuntimeError('Context.init() must only be called once')
        if domain_id is not None and domain_id < 0:
            raise RuntimeError(f'Domain id ({domain_id}) should not be lower than zero.')
        state = process_state()
        self.arguments = _global_arguments(list(state.process.argv) if args is None else args)
        self._domain_id = _default_domain_id(state.process.env.get('ROS_DOMAIN_ID', '')) if domain_id is None else domain_id
        self.alive = self.used = True
        state.contexts.append(self)
        if initialize_logging:
            from rclpy.impl.logging_state import logging_state

            logging_state().configure(self.arguments)

    def ok(self) -> bool:
        """Return whether the context has been initialised and not shut down."""
        current_task().poll()
        return self.alive

    def shutdown(self) -> None:
        """Shut the context down: wake every task that waits, and call the `on_shutdown` callbacks.

        :raises RuntimeError: when the context was never initialised.
        :raises RCLError: when the context was already shut down, for instance by Ctrl-C.
        """
        if not self.used:
            raise RuntimeError('Context must be initialized before it can be shutdown')
        self.ended_by_signal = False
        if not self.alive:
            raise with_facts(
                RCLError('failed to shutdown: rcl_shutdown already called on the given context'), 'programs.shutdown-twice'
            )
        self._end()

    def try_shutdown(self) -> None:
        """Shut the context down unless it is already shut down. Never raise an exception."""
        self.ended_by_signal = False
        if self.alive:
            self._end()

    def rcl_end_by_signal(self) -> None:
        """Shut the context down as Ctrl-C does. The callbacks of :meth:`on_shutdown` are not called, and later calls fail with a
        different message than after `shutdown()`.
        """
        if self.alive:
            self.ended_by_signal = True
            self._callbacks.clear()
            self._end()

    def _end(self) -> None:
        self.alive = False
        contexts = process_state().contexts
        if self in contexts:
            contexts.remove(self)
        if not contexts:  # rcl shuts its logging down here, so a later node of the same name starts again
            from rclpy.impl.logging_state import logging_state

            logging_state().rosout.clear()
        callbacks, self._callbacks = self._callbacks, []
        for callback in callbacks:
            callback()
        for executor in self.executors:
            executor.wake()
        for task in self.parked:
            task.wake()

    def on_shutdown(self, callback: Callable[[], object]) -> None:
        """Call `callback()` when the context is shut down, or immediately if it is already shut down.

        :raises TypeError: when `callback` is not callable.
        """
        if not callable(callback):
            raise TypeError('callback should be a callable, got {}', type(callback))  # rclpy's message has the same gap
        if self.used and not self.alive:
            callback()
        else:
            self._callbacks.append(callback)

    def get_domain_id(self) -> int:
        """Return the ID of the DDS domain. Raise RuntimeError before init."""
        if not self.used:
            raise RuntimeError('Context must be initialized before it can have a domain id')
        return self._domain_id

    def destroy(self) -> None:
        """Shut the context down unless it is already shut down."""
        self.try_shutdown()

    def rcl_track_node(self, node: NodeProtocol) -> None:
        """Register a node of this context."""
        self._nodes.append(node)

    def rcl_untrack_node(self, node: NodeProtocol) -> None:
        """Unregister a node of this context."""
        if node in self._nodes:
            self._nodes.remove(node)

    def rcl_park(self, deadline_ns: int | None = None) -> bool:
        """Park the running task until another task wakes it, the deadline is reached, or this context is shut down. Return
        False if the deadline came first.
        """
        task = current_task()
        self.parked.append(task)
        try:
            return task.park(deadline_ns)
        finally:
            self.parked.remove(task)

    def __enter__(self) -> Context:
        self.init()
        return self

    def __exit__(self, *_: Any) -> None:
        self.try_shutdown()


def _global_arguments(arguments: list[str]) -> RosArguments:
    """Return the parsed arguments of a whole program. For invalid arguments, log the reason and raise RCLError."""
    if not isinstance(arguments, list):
        raise TypeError(f'incompatible constructor arguments: args must be a list, not {type(arguments).__name__}')
    try:
        read = parse_or_raise(arguments)
    except RCLInvalidROSArgsError as error:
        _log(40, 'Failed to parse global arguments')
        reason = str(error).removeprefix(_REFUSED)
        raise with_facts_of(RCLError(f'failed to initialize rcl: {reason}'), error) from None
    problem = namespace_problem(read.settings.get('enclave', '/'))
    if problem is not None:
        reason = f"'{problem[0].replace('namespace', 'context name', 1)}'. Invalid index: {problem[1]}"
        raise RCLError(f'failed to initialize rcl: Enclave name is not valid: {reason}')
    return read


_REFUSED = 'Failed to parse ROS arguments: '


def parse_or_raise(arguments: Iterable[str]) -> RosArguments:
    """Return the parsed command-line arguments. Raise the C layer's errors for invalid arguments."""
    argument_list = list(arguments)
    if not all(isinstance(argument, str) for argument in argument_list):
        raise TypeError('bad argument type for built-in operation')
    for argument in argument_list:
        argument.encode()  # like the C layer, this raises a UnicodeEncodeError for half a character (a surrogate)
    try:
        parsed = parse_ros_arguments(argument_list, current_process().host.parameter_entries)
    except RosArgumentsError as error:
        raise with_facts_of(RCLInvalidROSArgsError(_REFUSED + error.message), error) from None
    for rule in parsed.deprecated:
        _log(30, f"Found remap rule '{rule}'. This syntax is deprecated. Use '--ros-args --remap {rule}' instead.")
    if parsed.unknown:
        raise UnknownROSArgsError(repr(parsed.unknown))
    return parsed


def _log(severity: int, words: str) -> None:
    from rclpy.impl.logging_state import logging_state

    logging_state().output(severity, 'rcl', words)


def _default_domain_id(text: str) -> int:
    """Return the number at the start of `ROS_DOMAIN_ID`, as C does. Return 0 for an empty value.

    :raises RCLError: when the value does not begin with a number.
    """
    words = text.strip()
    end = next((i for i, letter in enumerate(words) if letter not in '0123456789'), len(words))
    if words and not end:
        raise with_facts(
            RCLError('failed to initialize rcl: ROS_DOMAIN_ID is not an integral number'), 'programs.domain-id', value=text
        )
    return int(words[:end] or 0)
