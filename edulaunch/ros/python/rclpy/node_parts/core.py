"""The state of a node in one object, so that a student's own attributes cannot collide with it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from edulaunch.engine.facts import with_facts
from edulaunch.engine.graph.names import (
    RemapRule,
    absolute_namespace,
    expand_name,
    full_topic_name_problem,
    namespace_problem,
    node_name_problem,
    plain_name,
    remapped_name,
    remapped_namespace,
    remapped_node_name,
    topic_name_problem,
)
from edulaunch.engine.graph.ros_arguments import Override, RosArguments
from edulaunch.engine.processes.current import current_process
from edulaunch.ros.read_only import ReadOnly
from rclpy.exceptions import (
    InvalidNamespaceException,
    InvalidNodeNameException,
    InvalidServiceNameException,
    InvalidTopicNameException,
)
from rclpy.impl.entity import ReadyList
from rclpy.impl.refusals import after_shutdown, invalid_handle, without_context

if TYPE_CHECKING:
    from rclpy.callback_groups import CallbackGroup
    from rclpy.context import Context
    from rclpy.impl.protocols import ExecutorProtocol


class NodeCore:
    """A node's names, its place in the graph, and its entities in order of creation.

    This module cannot name the classes of the entities, because the modules of the entities import this module.

    :param name: the node name in the program, to which remap rules apply.
    :param namespace: the namespace in the program, to which remap rules apply.
    :raises InvalidNodeNameException, InvalidNamespaceException: for a name that breaks the rules.
    """

    clock: Any
    logger: Any
    default_callback_group: CallbackGroup
    parameters: Any
    overrides: dict[str, Override]
    time_source: Any
    life: Any

    def __init__(self, context: Context, name: str, namespace: str, arguments: list[RosArguments]) -> None:
        self.process = current_process()
        self.graph = self.process.graph
        self.context = context
        self.arguments = arguments
        self.rules: list[RemapRule] = [rule for parsed in arguments for rule in parsed.remap_rules]
        _check(node_name_problem, name, InvalidNodeNameException)
        _check(namespace_problem, absolute_namespace(namespace), InvalidNamespaceException)
        self.name = remapped_node_name(self.rules, name)
        self.namespace = remapped_namespace(self.rules, self.name, absolute_namespace(namespace))
        self.entry = self.graph.add_node(self.process, self.name, self.namespace)
        self.entry.participant = context
        self.full_name = self.entry.fully_qualified_name
        self.ready_list = ReadyList()
        self.executor: ExecutorProtocol | None = None
        self.destroyed = False
        self.was_spun = False
        self.declared: set[str] = set()  # every parameter that was ever declared
        self.takes_any_type = False  # whether a topic may have two types, which only the replacements of some simulators need
        self.publishers: list[Any] = []
        self.subscriptions: list[Any] = []
        self.clients: list[Any] = []
        self.services: list[Any] = []
        self.timers: list[Any] = []
        self.guards: list[Any] = []
        self.waitables: list[Any] = []
        self.rates: list[Any] = []
        self._number = 0

    def next_number(self) -> int:
        """Return the next number in order of creation. Entities of all kinds use the same sequence of numbers."""
        self._number += 1
        return self._number

    logger_name: ReadOnly[str] = ReadOnly('The full name with dots: `a.b.c` for node c in /a/b.', 'entry.logger_name')

    def check_alive(self) -> None:
        """Raise InvalidHandle if the node was destroyed."""
        if self.destroyed:
            raise with_facts(invalid_handle(), 'programs.destroyed-node', node=self.full_name)

    def check_usable(self, what: str) -> None:
        """Raise InvalidHandle if the node was destroyed, and RCLError `what: ...` if ROS 2 is shut down."""
        self.check_alive()
        if not self.context.alive:
            raise after_shutdown(f'{what}: rcl node')

    def check_context(self, what: str) -> None:
        """Raise RCLError if ROS 2 is shut down. Timers and guard conditions need only the context, not the node."""
        if not self.context.alive:
            raise without_context(what)

    def resolve(self, name: str, kind: str, only_expand: bool = False) -> str:
        """Return the absolute, remapped form of a topic or service name.

        :param kind: 'topic' or 'service'.
        :raises InvalidTopicNameException, InvalidServiceNameException: when the name breaks the rules.
        """
        self.check_alive()
        expanded = plain_name(name, self.namespace)
        if expanded is None:
            error = InvalidTopicNameException if kind == 'topic' else InvalidServiceNameException
            _check(topic_name_problem, name, error)
            expanded = expand_name(name, self.name, self.namespace)
            _check(full_topic_name_problem, expanded, error)
        return expanded if only_expand else remapped_name(self.rules, kind, expanded, self.name, self.namespace)

    def given_parameters(self) -> dict[str, Override]:
        """Return the parameter values of this node from command lines and files. Later sources replace earlier sources."""
        found: dict[str, Override] = {}
        origins = self.process.spec.parameter_origins
        for parsed in reversed(self.arguments):
            for name, override in parsed.overrides_for(self.full_name).items():
                found[name] = Override(override.value, origins.get(name, override.origin))
        return found


def core_of(node: Any) -> NodeCore:
    """Return the state of a node. All modules of rclpy except `node` itself use this function."""
    core: NodeCore = node._rclpy
    return core


def is_node(thing: Any) -> bool:
    """Return whether an object is a node whose constructor has run."""
    return isinstance(getattr(thing, '_rclpy', None), NodeCore)


def _check(problem_of: Any, name: str, error: Any) -> None:
    if not isinstance(name, str):
        raise TypeError(f'incompatible function arguments: a name must be a str, not {type(name).__name__}')
    problem = problem_of(name)
    if problem is not None:
        raise error(name, *problem)
