"""Functions that query the actions of the graph."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from edulaunch.engine.facts import with_facts_of
from edulaunch.ros.passed_on import passed_on
from rclpy._rclpy_pybind11 import RCLError

if TYPE_CHECKING:
    from rclpy.node import Node

NamesAndTypes = list[tuple[str, list[str]]]

_TOPIC = '/_action/feedback'
_TYPE = '_FeedbackMessage'


def get_action_names_and_types(node: Node) -> NamesAndTypes:
    """Return all actions that have a server or a client, with their types."""
    return _actions(node.get_topic_names_and_types, 'Failed to get action names and type')


def get_action_server_names_and_types_by_node(node: Node, remote_node_name: str, remote_node_namespace: str) -> NamesAndTypes:
    """Return the actions that a node serves. Raise RCLError for an unknown node."""
    return _actions(
        lambda: node.get_publisher_names_and_types_by_node(remote_node_name, remote_node_namespace),
        'Failed to get action server names and type',
    )


def get_action_client_names_and_types_by_node(node: Node, remote_node_name: str, remote_node_namespace: str) -> NamesAndTypes:
    """Return the actions for which a node has clients. Raise RCLError for an unknown node."""
    return _actions(
        lambda: node.get_subscriber_names_and_types_by_node(remote_node_name, remote_node_namespace),
        'Failed to get action client names and type',
    )


def _actions(topics: Callable[[], NamesAndTypes], failed: str) -> NamesAndTypes:
    """Return the actions to which feedback topics belong. An error message begins with `failed` and ends with the reason."""
    try:
        return [
            (name[: -len(_TOPIC)], [type_name.removesuffix(_TYPE) for type_name in types])
            for name, types in topics()
            if name.endswith(_TOPIC)
        ]
    except RCLError as error:
        reason = str(error).partition(': ')[2]
        raise with_facts_of(RCLError(f'{failed}: {reason}'), error) from None


__getattr__ = passed_on(__name__)
