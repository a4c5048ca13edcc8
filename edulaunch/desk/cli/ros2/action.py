"""`ros2 action`: list and describe actions, and send a goal."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from edulaunch.desk.cli.ros2 import cli_node, graph_names
from edulaunch.desk.cli.ros2.fill_message import FillError, fill_message, interface_class, parse_values
from edulaunch.desk.cli.ros2.output import say, say_lines, with_help
from edulaunch.engine.processes.current import current_process
from edulaunch.errors import InterfaceError
from edulaunch.ros.serialization.message_text import message_yaml

if TYPE_CHECKING:
    from rclpy.node import Node

CANCEL_PATIENCE_S = 1.0
"""After Ctrl-C, wait this many seconds for the result, because Ctrl-C often ends the server, too."""
STATUS_WORDS = ('UNKNOWN', 'ACCEPTED', 'EXECUTING', 'CANCELING', 'SUCCEEDED', 'CANCELED', 'ABORTED')


def info_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options and arguments of `ros2 action info`."""
    cli_node.add_arguments(parser)
    parser.add_argument('action_name', help="Name of the action to get info (e.g. '/fibonacci')")
    parser.add_argument('-t', '--show-types', action='store_true', help='Additionally show the action type')
    parser.add_argument('-c', '--count', action='store_true', help='Only display the number of action clients and action servers')


def info_verb(arguments: argparse.Namespace) -> None:
    """Print the nodes that have a client or a server of the action."""
    action = arguments.action_name
    with cli_node.cli_node(arguments) as node:
        sides = (
            ('clients', _nodes(node, action, graph_names.clients_by_node)),
            ('servers', _nodes(node, action, graph_names.servers_by_node)),
        )
    say(f'Action: {action}')
    for side, found in sides:
        say(f'Action {side}: {len(found)}')
        if not arguments.count:
            say_lines([f'    {name} [{", ".join(types)}]' if arguments.show_types else f'    {name}' for name, types in found])


def _nodes(
    node: Node, action: str, actions_by_node: Callable[[Node, str, str], graph_names.NamesAndTypes]
) -> graph_names.NamesAndTypes:
    found = []
    for name, namespace in node.get_node_names_and_namespaces():
        types = graph_names.types_of(action, actions_by_node(node, name, namespace))
        if types:
            found.append((f'{namespace.rstrip("/")}/{name}', types))
    return sorted(found)


def list_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options and arguments of `ros2 action list`."""
    graph_names.add_list_arguments(parser, 'action')


def list_verb(arguments: argparse.Namespace) -> None:
    """Print the names of the actions in alphabetical order."""
    with cli_node.cli_node(arguments) as node:
        graph_names.say_names(graph_names.action_names_and_types(node), arguments)


def type_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options and arguments of `ros2 action type`."""
    graph_names.add_name_arguments(parser, 'action', 'get type', '/fibonacci')


def type_verb(arguments: argparse.Namespace) -> int:
    """Print the type of the action. As in ROS 2, return 1 without a message if there is no such action."""
    with cli_node.cli_node(arguments) as node:
        return graph_names.say_types(arguments.action_name, graph_names.action_names_and_types(node))


def send_goal_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options and arguments of `ros2 action send_goal`."""
    parser.add_argument('action_name', help="Name of the ROS action (e.g. '/fibonacci')")
    parser.add_argument('action_type', help="Type of the ROS action (e.g. 'example_interfaces/action/Fibonacci')")
    group = parser.add_mutually_exclusive_group()
    group.add_argument('goal', nargs='?', default='{}', help='Goal request values in YAML format')
    group.add_argument('--stdin', action='store_true', help='Read values from standard input')
    parser.add_argument('-f', '--feedback', action='store_true', help='Echo feedback messages for the goal')


def send_goal_verb(arguments: argparse.Namespace) -> str | None:
    """Send the goal and wait for its result. Ctrl-C cancels the goal."""
    try:
        cls = interface_class(arguments.action_type, 'action')
    except InterfaceError as error:
        return with_help('The passed action type is invalid', error.help)
    goal = cls.Goal()
    try:
        fill_message(goal, parse_values(current_process().streams.stdin.read() if arguments.stdin else arguments.goal))
    except FillError as error:
        return str(error)
    name = f'_ros2cli_send_goal_{cls.TYPE.replace("/", "_")}'
    with cli_node.cli_node(name=name, signals='NO') as node:
        return _send(node, arguments, cls, goal)


def _send(node: Node, arguments: argparse.Namespace, cls: Any, goal: Any) -> str | None:
    import rclpy
    from rclpy.action import ActionClient

    try:
        client = ActionClient(node, cls, arguments.action_name)
    except ValueError as error:  # an invalid name
        return str(error)
    say('Waiting for an action server to become available...')
    client.wait_for_server()
    say(f'Sending goal:\n     {message_yaml(goal)}')
    accepted = client.send_goal_async(goal, _say_feedback if arguments.feedback else None)
    rclpy.spin_until_future_complete(node, accepted)
    handle: Any = accepted.result()
    if not handle.accepted:
        say('Goal was rejected.')
        return None
    say(f'Goal accepted with ID: {bytes(handle.goal_id.uuid).hex()}\n')
    finished = handle.get_result_async()
    try:
        rclpy.spin_until_future_complete(node, finished)
    except KeyboardInterrupt:
        return _cancel(node, handle)
    answer: Any = finished.result()
    say(f'Result:\n    {message_yaml(answer.result)}\nGoal finished with status: {STATUS_WORDS[answer.status]}')
    return None


def _say_feedback(message: Any) -> None:
    say(f'Feedback:\n    {message_yaml(message.feedback)}')


def _cancel(node: Node, handle: Any) -> str | None:
    import rclpy

    say('Canceling goal...')
    canceled = handle.cancel_goal_async()
    rclpy.spin_until_future_complete(node, canceled, timeout_sec=CANCEL_PATIENCE_S)
    answer: Any = canceled.result() if canceled.done() else None
    if answer is None or not answer.goals_canceling:
        return 'Failed to cancel goal'
    say('Goal canceled.')
    return None
