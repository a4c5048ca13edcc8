"""`ros2 topic find|info|list|type`: which topics there are. (`topic_echo`, `topic_pub` and `topic_measuring` have the others.)"""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING

from edulaunch.cli.ros2 import cli_node, names
from edulaunch.cli.ros2.output import say, with_help
from edulaunch.nearest import did_you_mean

if TYPE_CHECKING:
    from rclpy.node import Node


def find_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 topic find`."""
    cli_node.add_arguments(parser)
    parser.add_argument('topic_type', help="Name of the ROS topic type to filter for (e.g. 'std_msgs/msg/String')")
    parser.add_argument(
        '-c', '--count-topics', dest='count', action='store_true', help='Only display the number of topics discovered'
    )
    parser.add_argument('--include-hidden-topics', action='store_true', help='Consider hidden topics as well')


def find_verb(arguments: argparse.Namespace) -> None:
    """Print them, sorted."""
    with cli_node.cli_node(arguments) as node:
        topics = names.visible(node.get_topic_names_and_types(), arguments.include_hidden_topics)
    names.say_found(topics, arguments.topic_type, arguments.count)


def info_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 topic info`."""
    cli_node.add_arguments(parser)
    parser.add_argument('topic_name', help="Name of the ROS topic to get info (e.g. '/chatter')")
    parser.add_argument(
        '-v', '--verbose', action='store_true', help='Print each endpoint with its node, type and quality of service'
    )


def info_verb(arguments: argparse.Namespace) -> str | None:
    """Print type and counts; with -v each endpoint too."""
    topic, end = arguments.topic_name, '\n\n' if arguments.verbose else '\n'
    with cli_node.cli_node(arguments) as node:
        topics = node.get_topic_names_and_types()
        types = names.types_of(topic, topics)
        if not types:
            return with_help(f"Unknown topic '{topic}'", did_you_mean(topic, [name for name, _ in topics]))
        say(f'Type: {types[0] if len(types) == 1 else types}', end)
        say(f'Publisher count: {node.count_publishers(topic)}', end)
        if arguments.verbose:
            for endpoint in node.get_publishers_info_by_topic(topic):
                say(str(endpoint), end)
        say(f'Subscription count: {node.count_subscribers(topic)}', end)
        if arguments.verbose:
            for endpoint in node.get_subscriptions_info_by_topic(topic):
                say(str(endpoint), end)
    return None


def list_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 topic list`."""
    cli_node.add_arguments(parser)
    names.add_list_arguments(parser, 'topic')
    parser.add_argument('--include-hidden-topics', action='store_true', help='Consider hidden topics as well')
    parser.add_argument('-v', '--verbose', action='store_true', help='List full details about each topic')


def list_verb(arguments: argparse.Namespace) -> None:
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


def type_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 topic type`."""
    cli_node.add_arguments(parser)
    parser.add_argument('topic_name', help="Name of the ROS topic to get type (e.g. '/chatter')")


def type_verb(arguments: argparse.Namespace) -> int:
    """Print it; status 1 in silence when there is no such topic, as in ROS 2."""
    with cli_node.cli_node(arguments) as node:
        types = names.types_of(arguments.topic_name, node.get_topic_names_and_types())
    names.say_lines(types)
    return 0 if types else 1
