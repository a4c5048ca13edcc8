"""Names in the graph as commands list them."""

from __future__ import annotations

import argparse
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from edulaunch.cli.ros2.output import say

if TYPE_CHECKING:
    from rclpy.node import Node

NamesAndTypes = list[tuple[str, list[str]]]


def is_hidden(name: str) -> bool:
    """Whether a name is left out by default: one of its tokens starts with an underscore."""
    return any(token.startswith('_') for token in name.split('/'))


def visible(names_and_types: NamesAndTypes, include_hidden: bool) -> NamesAndTypes:
    """The entries without those of hidden names, unless they are wanted."""
    return [entry for entry in names_and_types if include_hidden or not is_hidden(entry[0])]


def absolute(name: str) -> str:
    """A node name with the slash that commands add."""
    return name if name.startswith('/') else f'/{name}'


def node_names(node: Node, include_hidden: bool = True) -> list[str]:
    """The full names of all nodes, sorted."""
    return sorted(name for name in node.get_fully_qualified_node_names() if include_hidden or not is_hidden(name))


def add_list_arguments(parser: argparse.ArgumentParser, what: str) -> None:
    """The options that all verbs `list` of names with types share."""
    parser.add_argument('-t', '--show-types', action='store_true', help=f'Additionally show the {what} type')
    parser.add_argument(
        '-c', f'--count-{what}s', dest='count', action='store_true', help=f'Only display the number of {what}s discovered'
    )


def say_names(names_and_types: NamesAndTypes, arguments: argparse.Namespace) -> None:
    """Print names, with types or counted as the options say."""
    if arguments.count:
        say(str(len(names_and_types)))
        return
    for name, types in names_and_types:
        say(f'{name} [{", ".join(types)}]' if arguments.show_types else name)


def say_found(names_and_types: NamesAndTypes, type_name: str, count: bool) -> None:
    """Print the names that have a type, or how many they are."""
    found = [name for name, types in names_and_types if type_name in types]
    if count:
        say(str(len(found)))
    else:
        say_lines(found)


def say_lines(lines: Sequence[str]) -> None:
    """Print each on a line of its own."""
    for line in lines:
        say(line)


def types_of(name: str, names_and_types: Iterable[tuple[str, list[str]]]) -> list[str]:
    """The types of a name, none when nobody uses it."""
    return next((types for known, types in names_and_types if known == name), [])
