"""`ros2 bag record`: record topics in a bag folder that every rosbag2 can read. The package `rosbags` writes the bag."""

from __future__ import annotations

import argparse
import os
import re
from collections.abc import Callable
from contextlib import suppress
from struct import unpack
from typing import TYPE_CHECKING, Any

from edulaunch.desk.cli.ros2 import cli_node, graph_names
from edulaunch.desk.cli.ros2.bag import EVENT_TOPIC, LOG_LEVELS, Keys, folder_of, new_folder, require_rosbags, set_level
from edulaunch.desk.cli.ros2.bag_write import BagMessage, write_bag
from edulaunch.desk.cli.ros2.output import with_help
from edulaunch.engine.graph import qos
from edulaunch.engine.graph.graph import Graph
from edulaunch.engine.graph.node_entry import NodeEntry
from edulaunch.engine.graph.topics import Publisher

if TYPE_CHECKING:
    from rclpy.node import Node

ACCEPTED = (
    (('-b', '--max-bag-size'), 'the bag has one file'),
    (('-d', '--max-bag-duration'), 'the bag has one file'),
    (('--max-cache-size',), 'the messages stay in memory until the end of the recording'),
    (('-f', '--serialization-format'), 'the messages are saved as cdr'),
    (('--qos-profile-overrides-path',), 'the recorder requests the QoS that the publishers offer'),
    (('--storage-config-file',), 'the storage has its usual settings'),
    (('--storage-preset-profile',), 'the storage has its usual settings'),
    (('--compression-queue-size',), 'the bag is compressed at the end'),
    (('--compression-threads',), 'the bag is compressed at the end'),
    (('--compression-threads-priority',), 'the bag is compressed at the end'),
)
"""Options of ROS 2 that have no effect in a simulation: the names of each option, and what happens instead."""


class BagTopic:
    """Takes the messages of a topic directly from the graph, so that the recorder does not have to run or copy for each message.

    :param graph: the graph of the simulation.
    :param node: the node of the recorder.
    :param publishers: the publishers of the topic. The subscription requests the QoS that all of these publishers offer.
    :param messages: the list to which arriving messages are appended.
    :param now_ns: a function that returns the time of arrival in nanoseconds. While it returns 0, messages are not recorded.
    :param is_paused: whether to ignore messages at first.
    """

    def __init__(
        self,
        graph: Graph,
        node: NodeEntry,
        publishers: list[Publisher],
        messages: list[BagMessage],
        now_ns: Callable[[], int],
        *,
        is_paused: bool = False,
    ) -> None:
        first = publishers[0]
        self.name = first.topic_name
        self.cls = first.cls
        self.offered = [publisher.qos for publisher in publishers]
        self._keep = messages.append
        self._now_ns = now_ns
        self.is_paused = is_paused
        self._queue: Any = ()
        subscription = graph.create_subscription(node, self.name, self.cls, _suitable(self.offered), self._on_ready)
        self._queue = subscription.queue
        self._on_ready()

    def _on_ready(self) -> None:
        while self._queue:
            wire = self._queue.popleft()[0]
            at_ns = 0 if self.is_paused else self._now_ns()
            if at_ns:
                self._keep((at_ns, self.name, wire))


def _suitable(offered: list[qos.QoS]) -> qos.QoS:
    reliable = all(each.reliability == qos.RELIABLE for each in offered)
    kept = all(each.durability == qos.TRANSIENT_LOCAL for each in offered)
    return qos.QoS(
        reliability=qos.RELIABLE if reliable else qos.BEST_EFFORT,
        durability=qos.TRANSIENT_LOCAL if kept else qos.VOLATILE,
        history=qos.KEEP_ALL,
    )


def record_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options of ROS 2 that choose the topics and the folder of the bag."""
    topics = parser.add_mutually_exclusive_group()
    topics.add_argument('topics', nargs='*', default=[], help='List of topics to record. (deprecated)')
    topics.add_argument('--topics', nargs='+', dest='more_topics', default=[], metavar='Topic', help='List of topics to record.')
    parser.add_argument('-a', '--all', action='store_true', help='Record all topics and services, except hidden topics.')
    parser.add_argument('--all-topics', action='store_true', help='Record all topics, except hidden topics.')
    parser.add_argument('--services', '--service', nargs='+', default=[], metavar='Service', help='List of services to record.')
    parser.add_argument('--all-services', action='store_true', help='Record all services via their event topics.')
    parser.add_argument('--topic-types', nargs='+', default=[], metavar='Type', help='List of topic types to record.')
    parser.add_argument('-e', '--regex', default='', help='Record only topics containing provided regular expression.')
    parser.add_argument('--exclude-regex', default='', help='Exclude topics containing provided regular expression.')
    parser.add_argument('-x', '--exclude', dest='exclude_regex', default='', help=argparse.SUPPRESS)  # the names of Humble
    parser.add_argument('--exclude-topics', nargs='+', default=[], metavar='Topic', help='List of topics not being recorded.')
    parser.add_argument(
        '--exclude-topic-types', nargs='+', default=[], metavar='Type', help='List of topic types not being recorded.'
    )
    parser.add_argument(
        '--exclude-services', nargs='+', default=[], metavar='Service', help='List of services not being recorded.'
    )
    parser.add_argument(
        '-o', '--output', metavar='OUTPUT', help='Destination of the bagfile to create, defaults to a timestamped folder.'
    )
    parser.add_argument(
        '-s', '--storage', choices=('mcap', 'sqlite3'), default='mcap', help="Storage identifier to be used, defaults to 'mcap'."
    )
    _add_discovery(parser)
    _add_control(parser)
    for names, hint in ACCEPTED:
        parser.add_argument(*names, help=f'accepted; {hint}')
    parser.add_argument('--snapshot-mode', action='store_true', help='refused; edulaunch has no snapshot service')


def _add_discovery(parser: argparse.ArgumentParser) -> None:
    """Add the options for the discovery of topics."""
    parser.add_argument(
        '-p',
        '--polling-interval',
        type=int,
        default=100,
        help='Time in ms to wait between querying available topics for recording (default: 100)',
    )
    parser.add_argument('--include-hidden-topics', action='store_true', help='Discover and record hidden topics as well.')
    parser.add_argument('--no-discovery', action='store_true', help='Disables topic auto discovery during recording.')
    parser.add_argument('--ignore-leaf-topics', action='store_true', help='Ignore topics without a subscription.')
    parser.add_argument(
        '--include-unpublished-topics', action='store_true', help='accepted; a topic is recorded once it has a publisher'
    )


def _add_control(parser: argparse.ArgumentParser) -> None:
    """Add the options for the clock, the keys, the name of the node, and the metadata of the bag."""
    parser.add_argument('--use-sim-time', action='store_true', help='Use the time of the /clock topic for message timestamps.')
    parser.add_argument('--start-paused', action='store_true', help='Start the recorder in a paused state.')
    parser.add_argument('--disable-keyboard-controls', action='store_true', help='disables keyboard controls for recorder')
    parser.add_argument('--node-name', default='rosbag2_recorder', help='Specify the recorder node name. Default is %(default)s.')
    parser.add_argument(
        '--custom-data', nargs='*', default=[], metavar='KEY=VALUE', help='Key=value pairs that are stored in the metadata.'
    )
    parser.add_argument('--log-level', choices=LOG_LEVELS, default='info', help='Logging level.')
    parser.add_argument(
        '--compression-mode',
        choices=('none', 'file', 'message'),
        default='none',
        help='Choose mode of compression for the storage.',
    )
    parser.add_argument('--compression-format', choices=('', 'zstd'), default='', help='Choose the compression format.')


def record_verb(arguments: argparse.Namespace) -> str | None:
    """Record until Ctrl-C, then write the bag to the folder in which the command runs. SPACE pauses and resumes."""
    wanted = [*arguments.topics, *arguments.more_topics, *(service.rstrip('/') + EVENT_TOPIC for service in arguments.services)]
    if not (
        wanted or arguments.all or arguments.all_topics or arguments.all_services or arguments.topic_types or arguments.regex
    ):
        return with_help(
            '[ERROR] [ros2bag]: Need to specify at least one option out of --all, --all-topics, --all-services, --services, '
            '--topics, --topic-types or --regex',
            'write `ros2 bag record -a` to record everything',
        )
    if arguments.snapshot_mode:
        return with_help(
            '[ERROR] [ros2bag]: edulaunch does not simulate --snapshot-mode.',
            'record without this option: the bag has all messages',
        )
    if arguments.use_sim_time and arguments.no_discovery:
        return (
            '[ERROR] [ros2bag]: --use-sim-time and --no-discovery both set, but are incompatible settings. The /clock topic '
            'needs to be discovered to record with sim time.'
        )
    require_rosbags()
    folder = new_folder() if arguments.output is None else folder_of(arguments.output)
    if os.path.exists(folder):
        name = os.path.basename(folder)
        return with_help(
            f"[ERROR] [ros2bag]: Output folder '{folder}' already exists.",
            f'delete the folder {name}, or write another name, as in -o {name}_2; without -o, each bag gets its own name',
        )
    with cli_node.cli_node(name=arguments.node_name, signals='SIGTERM') as node:
        recorder = BagRecorder(node, [graph_names.absolute(name) for name in wanted], arguments)
        with suppress(KeyboardInterrupt):  # Ctrl-C is the usual end of a recording
            recorder.record()
        recorder.write(folder)
    return None


class BagRecorder:
    """Subscribes to topics when they appear, and stores their messages."""

    def __init__(self, node: Node, wanted: list[str], arguments: argparse.Namespace) -> None:
        self._node = node
        self._wanted = wanted
        unwanted = [*arguments.exclude_topics, *(service.rstrip('/') + EVENT_TOPIC for service in arguments.exclude_services)]
        self._unwanted = {graph_names.absolute(name) for name in unwanted}
        self._arguments = arguments
        from edulaunch.ros.node_facts import core_of

        self._core = core_of(node)
        self._log = node.get_logger()
        set_level(self._log, arguments.log_level)
        self._is_paused, self._is_complete = arguments.start_paused, False
        self._clock: list[BagMessage] = []
        self._clock_topic: BagTopic | None = None
        self.topics: dict[str, BagTopic] = {}
        self.messages: list[BagMessage] = []

    def record(self) -> None:
        """Record until ROS 2 is shut down.

        :raises KeyboardInterrupt: on Ctrl-C.
        """
        keys = None if self._arguments.disable_keyboard_controls else Keys()
        if keys is not None:
            self._log.info('Press SPACE for pausing/resuming')
        self._log.info('Listening for topics...')
        self._log.info('Event publisher thread: Starting')
        self._subscribe()
        self._log.info('Recording...')
        while cli_node.pause(self._node, self._arguments.polling_interval / 1000):
            if keys is not None and ' ' in keys.pressed():
                self._pause()
            self._follow_clock()
            if self._is_searching():
                self._subscribe()

    def _follow_clock(self) -> None:
        graph = self._core.graph
        if self._arguments.use_sim_time and self._clock_topic is None and '/clock' in graph.publishers:
            self._clock_topic = BagTopic(graph, self._core.entry, graph.publishers['/clock'], self._clock, lambda: 1)

    def _pause(self) -> None:
        self._is_paused = not self._is_paused
        self._log.info('Pausing recording.' if self._is_paused else 'Resuming recording.')
        for topic in self.topics.values():
            topic.is_paused = self._is_paused

    def _now_ns(self) -> int:
        """Return the time in nanoseconds for a message that arrives now. Return 0 if `/clock` has not published a time yet."""
        sim = self._core.entry.process.sim
        if not self._arguments.use_sim_time:
            return int(sim.now_ns)
        if not self._clock:
            return 0
        wire = self._clock[-1][2]
        del self._clock[:-1]
        seconds, nanoseconds = unpack('<iI', wire[4:12]) if isinstance(wire, bytes) else wire
        return int(seconds * 1_000_000_000 + nanoseconds)

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
        if topic not in self._core.graph.publishers or (chosen.exclude_regex and re.search(chosen.exclude_regex, topic)):
            return False
        if topic in self._unwanted or type_name in chosen.exclude_topic_types:
            return False
        if chosen.ignore_leaf_topics and not self._node.count_subscribers(topic):
            return False
        if topic in self._wanted:
            return True
        if is_event:
            return bool(chosen.all or chosen.all_services)
        if graph_names.is_hidden(topic) and not chosen.include_hidden_topics:
            return False
        by_name = chosen.regex and re.search(chosen.regex, topic)
        return bool(chosen.all or chosen.all_topics or by_name or type_name in chosen.topic_types)

    def _listen(self, topic: str) -> None:
        graph = self._core.graph
        self.topics[topic] = BagTopic(
            graph, self._core.entry, graph.publishers[topic], self.messages, self._now_ns, is_paused=self._is_paused
        )
        self._log.info(f"Subscribed to topic '{topic}'")

    def write(self, folder: str) -> None:
        """Write the bag to a folder, and log that the recording has ended."""
        self._log.info('Event publisher thread: Exiting')
        chosen = self._arguments
        write_bag(
            folder,
            chosen.storage,
            list(self.topics.values()),
            self.messages,
            compression=chosen.compression_mode,
            custom_data=dict(pair.split('=', 1) for pair in chosen.custom_data if '=' in pair),
        )
        self._log.info('Recording stopped')
