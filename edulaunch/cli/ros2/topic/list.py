"""`ros2 topic list`: which topics there are."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING

from edulaunch.cli.ros2 import cli_node, names
from edulaunch.cli.ros2.output import say

if TYPE_CHECKING:
    from rclpy.node import Node


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 topic list`."""
    cli_node.add_arguments(parser)
    names.add_list_arguments(parser, 'topic')
    parser.add_argument('--include-hidden-topics', action='store_true', help='Consider hidden topics as well')
    parser.add_argument('-v', '--verbose', action='store_true', help='List full details about each topic')


def main(arguments: argparse.Namespace) -> None:
    """Print them, sorted."""
    with cli_node.cli_node(arguments) as node:
        topics = names.visible(node.get_topic_names_and_types(), arguments.include_hidden_topics)
        if not arguments.verbose or arguments.count:
            names.say_names(topics, arguments)
            return
        _say_details(node, topics, 'Published topics:', 'publisher')
        _say_details(node, topics, 'Subscribed topics:', 'subscriber')


def _say_details(node: Node, topics: names.NamesAndTypes, heading: str, side: str) -> None:
    say(heading)
    for topic, types in topics:
        count = node.count_publishers(topic) if side == 'publisher' else node.count_subscribers(topic)
        if count:
            say(f' * {topic} [{", ".join(types)}] {count} {side}{"s" if count > 1 else ""}')
    say()
