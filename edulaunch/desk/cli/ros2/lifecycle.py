"""`ros2 lifecycle`: show the states of lifecycle nodes, and trigger transitions."""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

from edulaunch.desk.cli.ros2 import cli_node, graph_names, node_parameters
from edulaunch.desk.cli.ros2 import node as node_command
from edulaunch.desk.cli.ros2.output import complain, say, say_lines, with_help
from edulaunch.engine.nearest import did_you_mean

if TYPE_CHECKING:
    from rclpy.node import Node

_SERVICE, _TYPE = '/get_state', 'lifecycle_msgs/srv/GetState'


def _common_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options for discovery and for hidden nodes."""
    cli_node.add_arguments(parser)
    parser.add_argument('--include-hidden-nodes', action='store_true', help='Consider hidden nodes as well')


def _lifecycle_nodes(node: Node, include_hidden: bool) -> list[str]:
    """Return the full names of all lifecycle nodes, sorted. A lifecycle node has a service for its state."""
    served = (name for name, types in node.get_service_names_and_types() if name.endswith(_SERVICE) and _TYPE in types)
    return sorted(
        name for service in served if include_hidden or not graph_names.is_hidden(name := service.removesuffix(_SERVICE))
    )


class LifecycleNodeOf(node_parameters.OtherNode):
    """Calls the lifecycle services of the node `name`."""

    PACKAGE = 'lifecycle_msgs'

    def state(self) -> str:
        """Return the label and the number of the node's state, such as 'active [3]'."""
        state = self._call('get_state', 'GetState').current_state
        return f'{state.label} [{state.id}]'

    def transitions(self, every: bool = False) -> list[Any]:
        """Return the descriptions of the transitions that are possible now. If `every` is True, return all transitions."""
        service = 'get_transition_graph' if every else 'get_available_transitions'
        return list(self._call(service, 'GetAvailableTransitions').available_transitions)

    def change(self, number: int) -> bool:
        """Trigger the transition with this number. Return whether it succeeded."""
        from lifecycle_msgs.msg import Transition

        return bool(self._call('change_state', 'ChangeState', transition=Transition(id=number)).success)


@contextmanager
def lifecycle_node(arguments: argparse.Namespace) -> Iterator[LifecycleNodeOf]:
    """Provide the lifecycle node that the command line names, for a `with` statement.

    :raises NodeNotFound: when no lifecycle node has this name, with the message of ROS 2.
    """
    name = graph_names.absolute(arguments.node_name)
    with cli_node.cli_node(arguments) as node:
        known = _lifecycle_nodes(node, arguments.include_hidden_nodes)
        if name not in known:
            raise node_parameters.NodeNotFound(
                with_help('Node not found', did_you_mean(name, known) or 'see `ros2 lifecycle nodes`')
            )
        yield LifecycleNodeOf(node, name)


def described(transition: Any) -> str:
    """Return the line that ROS 2 prints for a transition, such as '- configure [1]'."""
    return f'- {transition.label} [{transition.id}]'


def get_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options and arguments of `ros2 lifecycle get`."""
    _common_arguments(parser)
    parser.add_argument('node_name', nargs='?', help='Name of the ROS node')


def get_verb(arguments: argparse.Namespace) -> None:
    """Print the label and the number of the node's state.

    If the user names no node, print all lifecycle nodes with their states.
    """
    if arguments.node_name is not None:
        with lifecycle_node(arguments) as one:
            say(one.state())
        return
    with cli_node.cli_node(arguments) as node:
        for name in _lifecycle_nodes(node, arguments.include_hidden_nodes):
            say(f'{name}: {LifecycleNodeOf(node, name).state()}')


def list_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options and arguments of `ros2 lifecycle list`."""
    _common_arguments(parser)
    parser.add_argument('node_name', help='Name of the ROS node')
    parser.add_argument('-a', '--all', action='store_true', help='Display all existing transitions')


def list_verb(arguments: argparse.Namespace) -> None:
    """Print each transition with its start state and its goal state."""
    with lifecycle_node(arguments) as node:
        for found in node.transitions(arguments.all):
            say(described(found.transition))
            say(f'\tStart: {found.start_state.label}')
            say(f'\tGoal: {found.goal_state.label}')


nodes_arguments = node_command.list_arguments


def nodes_verb(arguments: argparse.Namespace) -> None:
    """Print the full names of the lifecycle nodes in alphabetical order, or only their number."""
    with cli_node.cli_node(arguments) as node:
        found = _lifecycle_nodes(node, arguments.all)
    if arguments.count_nodes:
        say(str(len(found)))
    else:
        say_lines(found)


def set_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options and arguments of `ros2 lifecycle set`."""
    _common_arguments(parser)
    parser.add_argument('node_name', help='Name of the ROS node')
    parser.add_argument('transition', help='The lifecycle transition')


def set_verb(arguments: argparse.Namespace) -> str | None:
    """Trigger the transition and print the result. Return an error message if the transition is not possible now.

    As in ROS 2, the exit code is 0 even if the transition fails.
    """
    with lifecycle_node(arguments) as node:
        possible = [found.transition for found in node.transitions()]
        number = next((one.id for one in possible if arguments.transition in (one.label, str(one.id))), None)
        if number is None:
            return '\n'.join(['Unknown transition requested, available ones are:', *map(described, possible)])
        successful = node.change(number)
    if successful:
        say('Transitioning successful')
    else:
        complain('Transitioning failed')
    return None
