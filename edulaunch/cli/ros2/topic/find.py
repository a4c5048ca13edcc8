"""`ros2 topic find`: the topics of a type."""

from __future__ import annotations

import argparse

from edulaunch.cli.ros2 import cli_node, names


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 topic find`."""
    cli_node.add_arguments(parser)
    parser.add_argument('topic_type', help="Name of the ROS topic type to filter for (e.g. 'std_msgs/msg/String')")
    parser.add_argument(
        '-c', '--count-topics', dest='count', action='store_true', help='Only display the number of topics discovered'
    )
    parser.add_argument('--include-hidden-topics', action='store_true', help='Consider hidden topics as well')


def main(arguments: argparse.Namespace) -> None:
    """Print them, sorted."""
    with cli_node.cli_node(arguments) as node:
        topics = names.visible(node.get_topic_names_and_types(), arguments.include_hidden_topics)
    names.say_found(topics, arguments.topic_type, arguments.count)
