"""Which actions there are."""
from __future__ import annotations

from typing import TYPE_CHECKING

from rclpy.impl.passed_on import passed_on

if TYPE_CHECKING:
    from rclpy.node import Node

NamesAndTypes = list[tuple[str, list[str]]]

_TOPIC = '/_action/feedback'
_TYPE = '_FeedbackMessage'


def get_action_names_and_types(node: Node) -> NamesAndTypes:
    """All actions that have a server or client, with their types."""
    return _actions(node.get_topic_names_and_types())


def get_action_server_names_and_types_by_node(node: Node, remote_node_name: str, remote_node_namespace: str) -> NamesAndTypes:
    """The actions that a node serves. Raises NodeNameNonExistentError for an unknown node."""
    return _actions(node.get_publisher_names_and_types_by_node(remote_node_name, remote_node_namespace))


def get_action_client_names_and_types_by_node(node: Node, remote_node_name: str, remote_node_namespace: str) -> NamesAndTypes:
    """The actions that a node has clients of. Raises NodeNameNonExistentError for an unknown node."""
    return _actions(node.get_subscriber_names_and_types_by_node(remote_node_name, remote_node_namespace))


def _actions(topics: NamesAndTypes) -> NamesAndTypes:
    """An action shows by its feedback topic."""
    return [(name[:-len(_TOPIC)], [type_name.removesuffix(_TYPE) for type_name in types])
            for name, types in topics if name.endswith(_TOPIC)]


__getattr__ = passed_on(__name__, {
    'typing': 'List Tuple', 'rclpy.node': 'Node',
})
