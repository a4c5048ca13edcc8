"""`ros2 bag record`: record topics into a bag."""

from __future__ import annotations

import argparse
import os
import re
from contextlib import suppress
from importlib.util import find_spec
from typing import TYPE_CHECKING

from edulaunch.cli.ros2 import cli_node, names
from edulaunch.cli.ros2.bag.topic import BagMessage, BagTopic
from edulaunch.cli.ros2.output import with_help
from edulaunch.processes.current import current_process

if TYPE_CHECKING:
    from rclpy.node import Node

MISSING = (
    "no bag is written, because 'rosbags' is not installed (pip install edulaunch[bags]); "
    'the recording of the run itself has all messages'
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options of ROS 2 that choose topics and the place of the bag."""
    parser.add_argument('topics', nargs='*', help='List of topics to record.')
    parser.add_argument('--topics', nargs='+', dest='more_topics', default=[], metavar='Topic', help='List of topics to record.')
    parser.add_argument('-a', '--all', action='store_true', help='Record all topics and services.')
    parser.add_argument('--all-topics', action='store_true', help='Record all topics.')
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
    """Record until interrupted; then write the bag into the folder where the command runs."""
    wanted = [*arguments.topics, *arguments.more_topics]
    if not (wanted or arguments.all or arguments.all_topics or arguments.regex):
        return with_help(
            'Must specify only one option out of --all, --all-topics, --topics, --topic-types, or --regex',
            'write `ros2 bag record -a` to record everything',
        )
    folder = _folder(arguments.output)
    if os.path.exists(folder):
        return f"[ERROR] [ros2bag]: Output folder '{folder}' already exists."
    with cli_node.cli_node(name='rosbag2_recorder') as node:
        recorder = BagRecorder(node, [names.absolute(name) for name in wanted], arguments)
        with suppress(KeyboardInterrupt):  # this is how one ends a recording
            recorder.record()
        recorder.write(folder, arguments.storage)
    return None


def _folder(output: str | None) -> str:
    process = current_process()
    if output is None:
        from datetime import datetime, timezone

        moment = datetime.fromtimestamp(process.sim.now_ns // 1_000_000_000, timezone.utc)
        output = f'rosbag2_{moment:%Y_%m_%d-%H_%M_%S}'
    return os.path.abspath(os.path.join(process.spec.cwd or '', output))


class BagRecorder:
    """Subscribes to topics as they appear, and keeps what is published."""

    def __init__(self, node: Node, wanted: list[str], arguments: argparse.Namespace) -> None:
        self._node = node
        self._wanted = wanted
        self._arguments = arguments
        self._log = node.get_logger()
        self.topics: dict[str, BagTopic] = {}
        self.messages: list[BagMessage] = []

    def record(self) -> None:
        """Listen until ROS 2 is shut down. Raises KeyboardInterrupt on Ctrl-C."""
        if find_spec('rosbags') is None:
            self._log.warning(MISSING)
        self._log.info('Press SPACE for pausing/resuming')
        self._log.info('Listening for topics...')
        self._log.info('Event publisher thread: Starting')
        self._subscribe()
        self._log.info('Recording...')
        while self._is_searching() and cli_node.pause(self._node, self._arguments.polling_interval / 1000):
            self._subscribe()
        while cli_node.pause(self._node, 3600.0):
            pass

    def _is_searching(self) -> bool:
        if self._arguments.no_discovery:
            return False
        if self._wanted and all(topic in self.topics for topic in self._wanted):
            self._log.info('All requested topics are subscribed. Stopping discovery...')
            return False
        return True

    def _subscribe(self) -> None:
        for topic, types in self._node.get_topic_names_and_types():
            if topic not in self.topics and len(types) == 1 and self._is_wanted(topic):
                self._listen(topic)

    def _is_wanted(self, topic: str) -> bool:
        chosen, graph = self._arguments, self._node._rclpy.graph
        if topic not in graph.publishers or (
            names.is_hidden(topic) and not chosen.include_hidden_topics and topic not in self._wanted
        ):
            return False
        if chosen.exclude and re.search(chosen.exclude, topic):
            return False
        return topic in self._wanted or chosen.all or chosen.all_topics or bool(chosen.regex and re.search(chosen.regex, topic))

    def _listen(self, topic: str) -> None:
        graph = self._node._rclpy.graph
        self.topics[topic] = BagTopic(self._node._rclpy.entry, graph.publishers[topic], self.messages)
        self._log.info(f"Subscribed to topic '{topic}'")

    def write(self, folder: str, storage: str) -> None:
        """Write the bag, if it can be written, and say that the recording is over."""
        self._log.info('Event publisher thread: Exiting')
        if find_spec('rosbags') is not None:
            from edulaunch.cli.ros2.bag.writing import write_bag

            write_bag(folder, storage, list(self.topics.values()), self.messages)
        self._log.info('Recording stopped')
