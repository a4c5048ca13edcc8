"""`ros2 action send_goal`: send a goal, and wait for what becomes of it."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from edulaunch.cli.ros2 import cli_node
from edulaunch.cli.ros2.fill_message import FillError, fill_message, parse_values
from edulaunch.cli.ros2.interface_class import interface_class
from edulaunch.cli.ros2.output import say, with_help
from edulaunch.errors import InterfaceError
from edulaunch.interfaces.message_text import message_yaml
from edulaunch.processes.current import current_process

if TYPE_CHECKING:
    from rclpy.node import Node

CANCEL_PATIENCE_S = 1.0
"""Ctrl-C often ends the server too; then there is nobody to wait for."""


STATUS_WORDS = ('UNKNOWN', 'ACCEPTED', 'EXECUTING', 'CANCELING', 'SUCCEEDED', 'CANCELED', 'ABORTED')


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 action send_goal`."""
    parser.add_argument('action_name', help="Name of the ROS action (e.g. '/fibonacci')")
    parser.add_argument('action_type', help="Type of the ROS action (e.g. 'example_interfaces/action/Fibonacci')")
    group = parser.add_mutually_exclusive_group()
    group.add_argument('goal', nargs='?', default='{}', help='Goal request values in YAML format')
    group.add_argument('--stdin', action='store_true', help='Read values from standard input')
    parser.add_argument('-f', '--feedback', action='store_true', help='Echo feedback messages for the goal')


def main(arguments: argparse.Namespace) -> str | None:
    """Send it; Ctrl-C cancels it."""
    try:
        cls = interface_class(arguments.action_type, 'action')
    except InterfaceError as error:
        return with_help('The passed action type is invalid', error.help)
    goal = cls.Goal()
    try:
        fill_message(goal, parse_values(current_process().stdin.read() if arguments.stdin else arguments.goal))
    except FillError as error:
        return str(error)
    name = f'_ros2cli_send_goal_{cls.TYPE.replace("/", "_")}'
    with cli_node.cli_node(name=name, handle_signals=False) as node:
        return _send(node, arguments, cls, goal)


def _send(node: Node, arguments: argparse.Namespace, cls: Any, goal: Any) -> str | None:
    import rclpy
    from rclpy.action import ActionClient

    client = ActionClient(node, cls, arguments.action_name)
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
