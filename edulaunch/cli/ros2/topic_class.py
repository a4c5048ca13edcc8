"""The message class of a topic that a command is to listen to."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from edulaunch.cli.ros2 import cli_node, names
from edulaunch.cli.ros2.interface_class import interface_class
from edulaunch.cli.ros2.output import complain, with_help
from edulaunch.errors import InterfaceError
from edulaunch.nearest import did_you_mean

if TYPE_CHECKING:
    from rclpy.node import Node

UNKNOWN = 'Could not determine the type for the passed topic'


def topic_class(node: Node, topic: str, type_text: str | None, *, verb: str, wait: bool = False) -> Any:
    """The class of `type_text`, else of what is published; or the text of an error.

    :param wait: whether to wait, with a warning, until the topic appears.
    """
    if type_text is not None:
        try:
            return interface_class(type_text, 'msg')
        except InterfaceError as error:
            return with_help('The passed message type is invalid', error.help)
    name = node.resolve_topic_name(topic)
    types = _types(node, name)
    if not types:
        complain(f'WARNING: topic [{name}] does not appear to be published yet')
        while wait and not types and cli_node.pause(node, 0.1):
            types = _types(node, name)
    if not types:
        return with_help(UNKNOWN, did_you_mean(name, [known for known, _ in node.get_topic_names_and_types()]))
    if len(types) > 1:
        return f"Cannot {verb} topic '{topic}', as it contains more than one type: [{', '.join(types)}]"
    return interface_class(types[0], 'msg')


def _types(node: Node, name: str) -> list[str]:
    return names.types_of(name, node.get_topic_names_and_types())
