"""List the names in the graph with their types, for the commands about topics, services, actions and nodes."""

from __future__ import annotations

import argparse
from collections.abc import Iterable
from typing import TYPE_CHECKING

from edulaunch.desk.cli.ros2 import cli_node
from edulaunch.desk.cli.ros2.output import say, say_lines

if TYPE_CHECKING:
    from rclpy.node import Node

NamesAndTypes = list[tuple[str, list[str]]]
_MARK, _TYPE_END = '/_action/feedback', '_FeedbackMessage'


def is_hidden(name: str) -> bool:
    """Return whether a name is hidden, which means that one of its parts starts with an underscore."""
    return any(token.startswith('_') for token in name.split('/'))


def visible(names_and_types: NamesAndTypes, include_hidden: bool) -> NamesAndTypes:
    """Return the entries. Leave out hidden names unless `include_hidden` is True."""
    return [entry for entry in names_and_types if include_hidden or not is_hidden(entry[0])]


def absolute(name: str) -> str:
    """Return a node name with a leading slash."""
    return name if name.startswith('/') else f'/{name}'


def node_names(node: Node, include_hidden: bool = True) -> list[str]:
    """Return the full names of all nodes, sorted. Leave out hidden nodes if `include_hidden` is False."""
    return sorted(name for name in node.get_fully_qualified_node_names() if include_hidden or not is_hidden(name))


def add_name_arguments(parser: argparse.ArgumentParser, what: str, purpose: str, example: str) -> None:
    """Add the options for discovery, and the argument for the name of a topic, service or action.

    :param parser: the parser to extend.
    :param what: 'topic', 'service' or 'action'.
    :param purpose: the purpose of the verb for the help, such as 'get type'.
    :param example: an example of a name for the help.
    """
    cli_node.add_arguments(parser)
    parser.add_argument(f'{what}_name', help=f"Name of the ROS {what} to {purpose} (e.g. '{example}')")


def add_find_arguments(parser: argparse.ArgumentParser, what: str, example: str) -> None:
    """Add the arguments that all `find` verbs have."""
    cli_node.add_arguments(parser)
    parser.add_argument(f'{what}_type', help=f"Name of the ROS {what} type to filter for (e.g. '{example}')")
    _add_count(parser, what)
    add_hidden(parser, what)


def add_list_arguments(parser: argparse.ArgumentParser, what: str) -> None:
    """Add the arguments that all `list` verbs for topics, services and actions have."""
    cli_node.add_arguments(parser)
    parser.add_argument('-t', '--show-types', action='store_true', help=f'Additionally show the {what} type')
    _add_count(parser, what)


def _add_count(parser: argparse.ArgumentParser, what: str) -> None:
    text = f'Only display the number of {what}s discovered'
    parser.add_argument('-c', f'--count-{what}s', dest='count', action='store_true', help=text)


def add_hidden(parser: argparse.ArgumentParser, what: str) -> None:
    """Add the option that includes hidden names."""
    parser.add_argument(f'--include-hidden-{what}s', action='store_true', help=f'Consider hidden {what}s as well')


def say_names(names_and_types: NamesAndTypes, arguments: argparse.Namespace) -> None:
    """Print the names, the names with their types, or only the number of names. The options choose the form."""
    if arguments.count:
        say(str(len(names_and_types)))
        return
    for name, types in names_and_types:
        say(f'{name} [{", ".join(types)}]' if arguments.show_types else name)


def say_found(names_and_types: NamesAndTypes, type_name: str, count: bool) -> None:
    """Print the names that have a type. If `count` is True, print only the number of these names."""
    found = [name for name, types in names_and_types if type_name in types]
    if count:
        say(str(len(found)))
    else:
        say_lines(found)


def types_of(name: str, names_and_types: Iterable[tuple[str, list[str]]]) -> list[str]:
    """Return the types of a name. Return an empty list if no node uses the name."""
    return next((types for known, types in names_and_types if known == name), [])


def say_types(name: str, names_and_types: NamesAndTypes) -> int:
    """Print the types of a name. As in ROS 2, return 1 without a message if no node uses the name."""
    types = types_of(name, names_and_types)
    say_lines(types)
    return 0 if types else 1


def servers_by_node(node: Node, name: str, namespace: str) -> NamesAndTypes:
    """Return the actions for which a node has a server. An action server publishes the action's feedback topic."""
    return _actions(node.get_publisher_names_and_types_by_node(name, namespace))


def clients_by_node(node: Node, name: str, namespace: str) -> NamesAndTypes:
    """Return the actions for which a node has a client. An action client subscribes to the action's feedback topic."""
    return _actions(node.get_subscriber_names_and_types_by_node(name, namespace))


def action_names_and_types(node: Node) -> NamesAndTypes:
    """Return all actions that have a server or a client, with their types."""
    return _actions(node.get_topic_names_and_types())


def _actions(topics: NamesAndTypes) -> NamesAndTypes:
    return [
        (topic.removesuffix(_MARK), [type_name.removesuffix(_TYPE_END) for type_name in types])
        for topic, types in topics
        if topic.endswith(_MARK)
    ]
