"""The class `Node`."""

from __future__ import annotations

from collections.abc import Iterator
from types import FunctionType
from typing import TYPE_CHECKING, Any

from edulaunch.engine.facts import with_facts
from edulaunch.ros.passed_on import passed_on
from edulaunch.ros.read_only import ReadOnly
from rclpy._rclpy_pybind11 import NodeNameNonExistentError
from rclpy.callback_groups import CallbackGroup, MutuallyExclusiveCallbackGroup
from rclpy.clock import ROSClock
from rclpy.context import Context, parse_or_raise
from rclpy.exceptions import NotInitializedException
from rclpy.impl.entity import Handle
from rclpy.impl.facts import odd_facts
from rclpy.impl.logging_state import logging_state
from rclpy.impl.own_names import AT_START, check_own_names, private_names
from rclpy.impl.rcutils_logger import RcutilsLogger
from rclpy.node_parts.core import NodeCore
from rclpy.node_parts.entities import NodeEntities
from rclpy.node_parts.graph_queries import NodeGraphQueries
from rclpy.node_parts.parameter_store import ParameterEvents, ParameterStore
from rclpy.node_parts.parameters import NodeParameters
from rclpy.node_parts.timers import NodeTimers
from rclpy.parameter import PARAMETER_SEPARATOR_STRING, Parameter
from rclpy.qos import engine_qos, qos_profile_rosout_default
from rclpy.time_source import TimeSource
from rclpy.utilities import get_default_context

if TYPE_CHECKING:
    from rclpy.executors import Executor

__all__ = ['HIDDEN_NODE_PREFIX', 'Node', 'NodeNameNonExistentError', 'PARAMETER_SEPARATOR_STRING']

HIDDEN_NODE_PREFIX = '_'
"""The prefix of the names of nodes that `ros2 node list` does not show."""

_PRIVATE = {
    '_logger': lambda core: core.logger,
    '_clock': lambda core: core.clock,
    '_context': lambda core: core.context,
    '_default_callback_group': lambda core: core.default_callback_group,
    '_parameters': lambda core: core.parameters.values,
}
"""Private attributes of a node that programs use, if they do not define an attribute of that name."""


class Node(NodeEntities, NodeTimers, NodeParameters, NodeGraphQueries):
    """A node of the ROS graph.

    :param node_name: the node's name, which remap rules may change.
    :param context: the node's context; None means the default context.
    :param cli_args: arguments for this node only, beginning with `--ros-args`. They take precedence over the arguments of
        the program.
    :param namespace: the namespace of the node and of its relative names.
    :param use_global_arguments: whether the program's own `--ros-args` apply.
    :param parameter_overrides: Parameter objects whose values replace declared defaults.
    :param allow_undeclared_parameters: whether the program may set parameters that it has not declared.
    :param automatically_declare_parameters_from_overrides: whether the constructor declares every parameter that has an override.
    :raises NotInitializedException: before `rclpy.init()`.
    :raises InvalidNodeNameException, InvalidNamespaceException: for a name that breaks the rules.
    """

    _rclpy: NodeCore

    def __init__(
        self,
        node_name: str,
        *,
        context: Context | None = None,
        cli_args: list[str] | None = None,
        namespace: str | None = None,
        use_global_arguments: bool = True,
        enable_rosout: bool = True,
        start_parameter_services: bool = True,
        parameter_overrides: list[Parameter] | None = None,
        allow_undeclared_parameters: bool = False,
        automatically_declare_parameters_from_overrides: bool = False,
        enable_logger_service: bool = False,
    ) -> None:
        context = context or get_default_context()
        if not context.alive:
            raise NotInitializedException('cannot create node')
        arguments = [parse_or_raise(cli_args)] if cli_args else []
        if use_global_arguments:
            arguments.append(context.arguments)
        core = self._rclpy = NodeCore(context, node_name, namespace or '', arguments)
        core.graph.tracer.watch(core.entry, lambda: _odd_facts(self))
        core.logger = RcutilsLogger(core.logger_name)
        core.default_callback_group = MutuallyExclusiveCallbackGroup()
        core.clock = ROSClock()
        if enable_rosout:
            _create_rosout(core)
        core.overrides = core.given_parameters()
        events = ParameterEvents(self)
        core.overrides.update(events.from_arguments(parameter_overrides or ()))
        core.parameters = ParameterStore(allow_undeclared_parameters, core.check_alive, events.publish)
        context.rcl_track_node(self)
        check_own_names(self, AT_START)
        core.time_source = TimeSource()
        core.time_source.attach_clock(core.clock)
        if automatically_declare_parameters_from_overrides:
            from rcl_interfaces.msg import ParameterDescriptor

            self.declare_parameters(
                '',
                [(name, override.value, ParameterDescriptor()) for name, override in core.overrides.items()],
                ignore_override=True,
            )
        core.time_source.attach_node(self)
        _start_services(self, start_parameter_services, enable_logger_service)

    def __getattr__(self, name: str) -> Any:
        if name == '_rclpy':
            raise with_facts(
                AttributeError(f"'{type(self).__name__}' object has no attribute '_default_callback_group'"),
                'programs.no-super-init',
                node=type(self).__name__,
            )
        private = _PRIVATE.get(name)
        if private is None:
            raise AttributeError(f'{type(self).__name__!r} object has no attribute {name!r}', name=name, obj=self)
        return private(self._rclpy)

    @property
    def executor(self) -> Executor | None:
        """The executor that calls the node's callbacks. Setting this property moves the node to another executor."""
        # the core knows executors only by a protocol
        executor: Executor | None = self._rclpy.executor  # type: ignore[assignment]
        return executor

    @executor.setter
    def executor(self, new_executor: Executor | None) -> None:
        core = self._rclpy
        current = core.executor
        if current is new_executor:
            return
        if current is not None:
            current.remove_node(self)
            current.rcl_forget_work()
        core.executor = None
        if new_executor is not None:
            add_node = new_executor.add_node
            core.executor = new_executor
            add_node(self)

    context: ReadOnly[Context] = ReadOnly('The context that the node lives in.', '_rclpy.context')

    @property
    def default_callback_group(self) -> CallbackGroup:
        """The callback group that new entities belong to by default. Only one callback of this group runs at a time."""
        return self._rclpy.default_callback_group

    @property
    def handle(self) -> Handle:
        """The object that owns the node in the graph."""
        return Handle(self._rclpy.entry, lambda: self._rclpy.destroyed)

    def get_clock(self) -> ROSClock:
        """Return the node's clock."""
        clock: ROSClock = self._rclpy.clock
        return clock

    def get_logger(self) -> RcutilsLogger:
        """Return the node's logger."""
        logger: RcutilsLogger = self._rclpy.logger
        return logger

    def destroy_node(self) -> None:
        """Destroy the node and all its entities. A second call has no effect."""
        core = self._rclpy
        if core.destroyed:
            return
        core.graph.tracer.node_leaving(core.entry)
        core.destroyed = True
        for rate in list(core.rates):
            self.destroy_rate(rate)
        for entities in (core.publishers, core.subscriptions, core.clients, core.services, core.timers, core.guards):
            while entities:
                entities.pop().destroy()
        for waitable in list(core.waitables):
            self.remove_waitable(waitable)
        core.context.rcl_untrack_node(self)
        core.graph.remove_node(core.entry)
        core.ready_list.notify()


def _refuse_setting(name: str, made: property) -> property:
    def refuse(node: object, value: object) -> None:
        text = f"property '{name}' of '{type(node).__qualname__}' object has no setter"
        if name == 'handle':
            text = 'handle cannot be modified after node creation'
        raise with_facts(AttributeError(text), 'programs.own-property', attribute=name)

    return made.setter(refuse)


def _finish_node_class() -> None:
    """Make Python's errors name the class Node for every method, and explain `self.timers = []`."""
    for part in (*Node.__bases__, Node):
        for name, member in list(vars(part).items()):
            if isinstance(member, FunctionType):
                member.__qualname__ = f'Node.{name}'
            elif isinstance(member, property) and member.fset is None:
                setattr(part, name, _refuse_setting(name, member))


_finish_node_class()


def _odd_facts(node: Node) -> Iterator[tuple[str, dict[str, Any]]]:
    """Yield facts about unusual behaviour of the node. The recorder calls this when the node is destroyed or the recording
    ends.
    """
    yield from odd_facts(node._rclpy)
    yield from private_names(node)


def _start_services(node: Node, parameters: bool, logger: bool) -> None:
    if parameters:
        from rclpy.parameter_service import ParameterService

        ParameterService(node)
    if logger:
        from rclpy.logging_service import LoggingService

        LoggingService(node)
    from rclpy.type_description_service import TypeDescriptionService

    TypeDescriptionService(node)


def _create_rosout(core: NodeCore) -> None:
    """Create the publisher of the node's log messages. If several nodes share a name, only the first node has this publisher."""
    from rcl_interfaces.msg import Log

    publisher = core.graph.create_publisher(core.entry, '/rosout', Log, engine_qos(qos_profile_rosout_default))
    rosout = logging_state().rosout
    present = rosout.get(core.logger_name)
    if present is None or present.destroyed:
        rosout[core.logger_name] = publisher
        return
    logging_state().output(
        30,
        'rcl.logging_rosout',
        (
            f"Publisher already registered for node name: '{core.name}'. If this is due to multiple nodes with the same name "
            'then '
            f"all logs for the logger named '{core.logger_name}' will go out over the existing publisher. As soon as any node "
            'with '
            'that name is destructed it will unregister the publisher, preventing any further logs for that name from being '
            'published on the rosout topic.'
        ),
    )


__getattr__ = passed_on(__name__)
