"""`ros2 topic info`: who publishes and subscribes."""

from __future__ import annotations

import argparse

from edulaunch.cli.ros2 import cli_node, names
from edulaunch.cli.ros2.output import say, with_help
from edulaunch.nearest import did_you_mean


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 topic info`."""
    cli_node.add_arguments(parser)
    parser.add_argument('topic_name', help="Name of the ROS topic to get info (e.g. '/chatter')")
    parser.add_argument(
        '-v', '--verbose', action='store_true', help='Print each endpoint with its node, type and quality of service'
    )


def main(arguments: argparse.Namespace) -> str | None:
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
