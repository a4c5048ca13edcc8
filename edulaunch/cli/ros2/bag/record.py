"""`ros2 bag record`: record topics into a bag."""

from __future__ import annotations

import argparse
import os
import re
from contextlib import suppress
from typing import TYPE_CHECKING

from edulaunch.cli.ros2 import cli_node, names
from edulaunch.cli.ros2.bag.keys import Keys
from edulaunch.cli.ros2.bag.storage import EVENT_TOPIC, folder_of, new_folder
from edulaunch.cli.ros2.bag.topic import BagMessage, BagTopic
from edulaunch.cli.ros2.output import with_help

if TYPE_CHECKING:
    from rclpy.node import Node


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options of ROS 2 that choose topics and the place of the bag."""
    parser.add_argument('topics', nargs='*', help='List of topics to record.')
    parser.add_argument('--topics', nargs='+', dest='more_topics', default=[], metavar='Topic', help='List of topics to record.')
    parser.add_argument('-a', '--all', action='store_true', help='Record all topics and services.')
    parser.add_argument('--all-topics', action='store_true', help='Record all topics.')
    parser.add_argument('--services', '--service', nargs='+', default=[], metavar='Service', help='List of services to record.')
    parser.add_argument('--all-services', action='store_true', help='Record all services via their event topics.')
    parser.add_argument('--topic-types', nargs='+', default=[], metavar='Type', help='List of topic types to record.')
    parser.add_argument('-e', '--regex', default='', help='Record only topics containing provided regular expression.')
    parser.add_argument(
        '-x', '--exclude', '--exclude-regex', default='', help='Exclude topics containing provided regular expression.'
    )
    parser.add_argument(
        '-o', '--output', metavar='OUTPUT', help='Destination of the bagfile to create, defaults to a timestamped folder.'
    )
    parser.add_argument(
        '-s', '--storage', choices=('mcap', 'sqlite3'), default='mcap', help="Storage identifier to be used, defaults to 'mcap'."
    )
    _add_discovery(parser)


def _add_discovery(parser: argparse.ArgumentParser) -> None:
    """How topics are found."""
    parser.add_argument(
        '-p',
        '--polling-interval',
        type=int,
        default=100,
        help='Time in ms to wait between querying available topics for recording (default: 100)',
    )
    parser.add_argument('--include-hidden-topics', action='store_true', help='Discover and record hidden topics as well.')
    parser.add_argument('--no-discovery', action='store_true', help='Disables topic auto discovery during recording.')


def main(arguments: argparse.Namespace) -> str | None:
    """Record until interrupted; then write the bag into the folder where the command runs. SPACE pauses and goes on."""
    wanted = [*arguments.topics, *arguments.more_topics, *map(_event_topic, arguments.services)]
    if not (
        wanted or arguments.all or arguments.all_topics or arguments.all_services or arguments.topic_types or arguments.regex
    ):
        return with_help(
            'Must specify only one option out of --all, --all-topics, --all-services, --topics, --services, --topic-types, or '
            '--regex',
            'write `ros2 bag record -a` to record everything',
        )
    folder = new_folder() if arguments.output is None else folder_of(arguments.output)
    if os.path.exists(folder):
        return f"[ERROR] [ros2bag]: Output folder '{folder}' already exists."
    with cli_node.cli_node(name='rosbag2_recorder') as node:
        recorder = BagRecorder(node, [names.absolute(name) for name in wanted], arguments)
        with suppress(KeyboardInterrupt):  # this is how one ends a recording
            recorder.record()
        recorder.write(folder, arguments.storage)
    return None


def _event_topic(service: str) -> str:
    return service.rstrip('/') + EVENT_TOPIC


class BagRecorder:
    """Subscribes to topics as they appear, and keeps what is published."""

    def __init__(self, node: Node, wanted: list[str], arguments: argparse.Namespace) -> None:
        self._node = node
        self._wanted = wanted
        self._arguments = arguments
        self._log = node.get_logger()
        self._is_paused = self._is_complete = False
        self.topics: dict[str, BagTopic] = {}
        self.messages: list[BagMessage] = []

    def record(self) -> None:
        """Listen until ROS 2 is shut down. Raises KeyboardInterrupt on Ctrl-C."""
        self._log.info('Press SPACE for pausing/resuming')
        self._log.info('Listening for topics...')
        self._log.info('Event publisher thread: Starting')
        self._subscribe()
        self._log.info('Recording...')
        keys, every_s = Keys(), self._arguments.polling_interval / 1000
        while cli_node.pause(self._node, every_s):
            if ' ' in keys.pressed():
                self._pause()
            if self._is_searching():
                self._subscribe()

    def _pause(self) -> None:
        self._is_paused = not self._is_paused
        self._log.info('Pausing recording.' if self._is_paused else 'Resuming recording.')
        for topic in self.topics.values():
            topic.is_paused = self._is_paused

    def _is_searching(self) -> bool:
        if self._is_complete or self._arguments.no_discovery:
            return False
        if self._wanted and all(topic in self.topics for topic in self._wanted):
            self._log.info('All requested topics are subscribed. Stopping discovery...')
            self._is_complete = True
        return not self._is_complete

    def _subscribe(self) -> None:
        for topic, types in self._node.get_topic_names_and_types():
            if topic not in self.topics and len(types) == 1 and self._is_wanted(topic, types[0]):
                self._listen(topic)

    def _is_wanted(self, topic: str, type_name: str) -> bool:
        chosen, is_event = self._arguments, topic.endswith(EVENT_TOPIC)
        if topic not in self._node._rclpy.graph.publishers or (chosen.exclude and re.search(chosen.exclude, topic)):
            return False
        if topic in self._wanted:
            return True
        if is_event:
            return bool(chosen.all or chosen.all_services)
        if names.is_hidden(topic) and not chosen.include_hidden_topics:
            return False
        by_name = chosen.regex and re.search(chosen.regex, topic)
        return bool(chosen.all or chosen.all_topics or by_name or type_name in chosen.topic_types)

    def _listen(self, topic: str) -> None:
        graph = self._node._rclpy.graph
        self.topics[topic] = BagTopic(self._node._rclpy.entry, graph.publishers[topic], self.messages)
        self._log.info(f"Subscribed to topic '{topic}'")

    def write(self, folder: str, storage: str) -> None:
        """Write the bag, and say that the recording is over."""
        self._log.info('Event publisher thread: Exiting')
        from edulaunch.cli.ros2.bag.writing import write_bag

        write_bag(folder, storage, list(self.topics.values()), self.messages)
        self._log.info('Recording stopped')
