"""The lifecycle nodes of the graph, and asking them."""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

from edulaunch.cli.ros2 import cli_node, names
from edulaunch.cli.ros2.node_parameters import NodeNotFound
from edulaunch.cli.ros2.output import with_help
from edulaunch.nearest import did_you_mean

if TYPE_CHECKING:
    from rclpy.node import Node

_SERVICE, _TYPE = '/get_state', 'lifecycle_msgs/srv/GetState'


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Discovery, and whether hidden nodes count."""
    cli_node.add_arguments(parser)
    parser.add_argument('--include-hidden-nodes', action='store_true', help='Consider hidden nodes as well')


def found(node: Node, include_hidden: bool) -> list[str]:
    """The full names of all lifecycle nodes, sorted: those that serve their state."""
    served = (name for name, types in node.get_service_names_and_types() if name.endswith(_SERVICE) and _TYPE in types)
    return sorted(name for service in served if include_hidden or not names.is_hidden(name := service.removesuffix(_SERVICE)))


class LifecycleNodeOf:
    """The lifecycle node `name`, as seen from the node of a command."""

    def __init__(self, node: Node, name: str) -> None:
        self._node = node
        self.name = name

    def _call(self, service: str, cls: str, **fields: Any) -> Any:
        from lifecycle_msgs import srv

        return cli_node.call(self._node, f'{self.name}/{service}', getattr(srv, cls), **fields)

    def state(self) -> str:
        """Label and number of its state."""
        state = self._call('get_state', 'GetState').current_state
        return f'{state.label} [{state.id}]'

    def transitions(self, every: bool = False) -> list[Any]:
        """Descriptions of the transitions that it can make now, or of all."""
        service = 'get_transition_graph' if every else 'get_available_transitions'
        return list(self._call(service, 'GetAvailableTransitions').available_transitions)

    def change(self, number: int) -> bool:
        """Make a transition; whether that went well."""
        from lifecycle_msgs.msg import Transition

        return bool(self._call('change_state', 'ChangeState', transition=Transition(id=number)).success)


@contextmanager
def lifecycle_node(arguments: argparse.Namespace) -> Iterator[LifecycleNodeOf]:
    """The one that the command line names.

    :raises NodeNotFound: when there is none of that name; in the words of ROS 2.
    """
    name = names.absolute(arguments.node_name)
    with cli_node.cli_node(arguments) as node:
        known = found(node, arguments.include_hidden_nodes)
        if name not in known:
            raise NodeNotFound(with_help('Node not found', did_you_mean(name, known) or 'see `ros2 lifecycle nodes`'))
        yield LifecycleNodeOf(node, name)


def described(transition: Any) -> str:
    """A transition as ROS 2 lists it."""
    return f'- {transition.label} [{transition.id}]'
