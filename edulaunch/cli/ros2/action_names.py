"""Actions as the graph shows them: each is three services and two topics below `<action>/_action/`."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rclpy.node import Node

    from edulaunch.cli.ros2.names import NamesAndTypes

_MARK, _TYPE_END = '/_action/feedback', '_FeedbackMessage'


def servers_by_node(node: Node, name: str, namespace: str) -> NamesAndTypes:
    """The actions that a node serves: it publishes their feedback."""
    return _actions(node.get_publisher_names_and_types_by_node(name, namespace))


def clients_by_node(node: Node, name: str, namespace: str) -> NamesAndTypes:
    """The actions that a node uses: it listens to their feedback."""
    return _actions(node.get_subscriber_names_and_types_by_node(name, namespace))


def action_names_and_types(node: Node) -> NamesAndTypes:
    """All actions that are served or used."""
    return _actions(node.get_topic_names_and_types())


def _actions(topics: NamesAndTypes) -> NamesAndTypes:
    return [
        (topic.removesuffix(_MARK), [type_name.removesuffix(_TYPE_END) for type_name in types])
        for topic, types in topics
        if topic.endswith(_MARK)
    ]
