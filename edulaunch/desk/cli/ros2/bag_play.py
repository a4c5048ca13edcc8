"""`ros2 bag play`: publish the messages of a bag at their recorded times. The command can also publish /clock. A key pauses the
playback.
"""

from __future__ import annotations

import argparse
import math
import re
from typing import TYPE_CHECKING, Any

from edulaunch.desk.cli.ros2 import cli_node
from edulaunch.desk.cli.ros2.bag import (
    EVENT_TOPIC,
    EVENT_TYPE,
    LOG_LEVELS,
    Keys,
    event_kind,
    existing_path,
    messages_of,
    opened,
    set_level,
)
from edulaunch.desk.cli.ros2.bag_metadata import unreadable
from edulaunch.desk.cli.ros2.fill_message import interface_class
from edulaunch.engine.interfaces import current_registry
from edulaunch.engine.processes.current import current_process
from edulaunch.errors import InterfaceError

if TYPE_CHECKING:
    from collections.abc import Callable

    from rclpy.node import Node

REQUEST_RECEIVED = 1
LOOK_AT_KEYS_NS = 50_000_000
CLOCK_HZ = 40.0
ACCEPTED = (
    (('--read-ahead-queue-size',), 'the whole bag is read first'),
    (('--qos-profile-overrides-path',), 'all publishers are reliable'),
    (('--storage-config-file',), 'the storage has its usual settings'),
    (('--wait-for-all-acked',), 'a message arrives before the next one is published'),
)
"""Options of ROS 2 that have no effect in a simulation: the names of each option, and what happens instead."""


class Player:
    """Plays a bag: it contains the messages of the bag and the publishers for its topics.

    :ivar messages: (nanoseconds after the start of the playback, function that sends the message, message), sorted by time.
    """

    def __init__(self, node: Node, arguments: argparse.Namespace) -> None:
        self._node = node
        self._arguments = arguments
        self._log = node.get_logger()
        set_level(self._log, arguments.log_level)
        self._sim = current_process().sim
        self._names = dict(text.split(':=', 1) for text in arguments.remap if ':=' in text)
        self._keys = None if arguments.disable_keyboard_controls else Keys()
        self._is_paused = arguments.start_paused
        self._first_ns = 0
        self.messages: list[tuple[int, Callable[[Any], object], Any]] = []
        self._log.info(f'Set rate to {arguments.rate:g}')
        if self._keys is not None:
            self._log.info('Adding keyboard callbacks.')
            self._log.info('Press SPACE for Pause/Resume')

    def load(self, path: str) -> None:
        """Read the bag, and create a publisher for each topic. Create clients for the recorded service requests to repeat.

        :raises RuntimeError: when there is no bag, or the bag cannot be read.
        """
        chosen = self._arguments
        with opened(path) as reader:
            senders = {each.id: self._sender(each) for each in reader.connections if self._is_wanted(each.topic)}
            self._first_ns = reader.start_time + round(chosen.start_offset * 1e9)
            last_ns = self._last_ns()
            for connection, time_ns, data in messages_of(path, reader, start=self._first_ns, stop=last_ns):
                sender = senders.get(connection.id)
                if sender is not None and not (self._is_request(connection) and event_kind(data) != REQUEST_RECEIVED):
                    self.messages.append((time_ns - self._first_ns, sender[0], _message(path, data, sender[1])))

    def _last_ns(self) -> int | None:
        """Return the recorded time in nanoseconds at which the playback ends. Return None if the playback ends with the bag."""
        chosen = self._arguments
        duration_s, until_s, until_ns = chosen.playback_duration, chosen.playback_until_sec, chosen.playback_until_nsec
        ends = [
            *([self._first_ns + round(duration_s * 1e9)] if duration_s >= 0 else []),
            *([round(until_s * 1e9)] if until_s >= 0 else []),
            *([until_ns] if until_ns >= 0 else []),
        ]
        return min(ends, default=None)

    def _is_wanted(self, topic: str) -> bool:
        chosen, name = self._arguments, topic.removesuffix(EVENT_TOPIC)
        if name in (*chosen.exclude_topics, *chosen.exclude_services) or (
            chosen.exclude_regex and re.search(chosen.exclude_regex, name)
        ):
            return False
        if not (chosen.topics or chosen.services or chosen.regex):
            return True
        return name in (*chosen.topics, *chosen.services) or bool(chosen.regex and re.search(chosen.regex, name))

    def _is_request(self, connection: Any) -> bool:
        return bool(self._arguments.publish_service_requests and connection.topic.endswith(EVENT_TOPIC))

    def _sender(self, connection: Any) -> tuple[Callable[[Any], object], Any] | None:
        """Return a function that sends the messages of a topic, and the class of the messages.

        Return None if the type is unknown.
        """
        topic = self._names.get(connection.topic, connection.topic)
        try:
            cls = current_registry().get(connection.msgtype)
            if self._is_request(connection):
                service = interface_class(connection.msgtype.removesuffix(EVENT_TYPE), 'srv')
                client = self._node.create_client(service, topic.removesuffix(EVENT_TOPIC))
                return (lambda event: client.call_async(event.request[0]) if event.request else None), cls
            return self._node.create_publisher(cls, topic, 10).publish, cls
        except InterfaceError as error:
            self._log.warning(f"Ignoring a topic '{connection.topic}', reason: {error.message}.")
            return None

    def play_once(self) -> bool:
        """Publish all messages once. Return False if ROS 2 was shut down in the meantime."""
        cli_node.pause(self._node, self._arguments.delay)
        self._log.info('Playback until timestamp: -1')
        begin_ns, rate = self._sim.now_ns, self._arguments.rate
        tick = None if self._arguments.clock is None else round(1e9 / self._arguments.clock)
        clock = None if tick is None else self._clock()
        ticks = 0
        for offset_ns, send, message in self.messages:
            due_ns = round(offset_ns / rate)
            while clock is not None and tick is not None and ticks * tick <= due_ns:
                begin_ns = self._wait_until(begin_ns, ticks * tick)
                clock(self._first_ns + round(ticks * tick * rate))
                ticks += 1
            begin_ns = self._wait_until(begin_ns, due_ns)
            if not self._node.context.ok():
                return False
            send(message)
        return bool(self._node.context.ok())

    def _wait_until(self, begin_ns: int, offset_ns: int) -> int:
        """Wait until the playback reaches a time. A pause makes the wait longer.

        :param begin_ns: the simulated time in nanoseconds at which the playback began.
        :param offset_ns: the time to wait for, in nanoseconds after the beginning.
        :return: the new `begin_ns`, which is later by the duration of the pauses.
        """
        while self._node.context.ok() and (self._is_paused or self._sim.now_ns < begin_ns + offset_ns):
            before_ns = self._sim.now_ns
            look_ns = before_ns + LOOK_AT_KEYS_NS
            pressed = self._keys.pressed() if self._keys is not None else ''
            if ' ' in pressed:
                self._is_paused = not self._is_paused
                self._log.info('Pausing play.' if self._is_paused else 'Resuming play.')
                continue
            stops_ns = look_ns if self._is_paused else begin_ns + offset_ns
            cli_node.pause_until(self._node, min(look_ns, stops_ns) if self._keys is not None else stops_ns)
            begin_ns += self._sim.now_ns - before_ns if self._is_paused else 0
        return begin_ns

    def _clock(self) -> Callable[[int], None]:
        """Return a function that publishes a time (in nanoseconds) on the topic /clock."""
        clock_class = interface_class('rosgraph_msgs/msg/Clock', 'msg')
        publisher = self._node.create_publisher(clock_class, '/clock', 1)

        def publish(now_ns: int) -> None:
            message = clock_class()
            message.clock.sec, message.clock.nanosec = divmod(now_ns, 1_000_000_000)
            publisher.publish(message)

        return publish


def _message(path: str, data: Any, cls: Any) -> Any:
    """Return the message that bytes of a bag contain.

    :raises RuntimeError: when the bytes are not a message of this class.
    """
    from edulaunch.ros.serialization.cdr import deserialize

    try:
        return deserialize(bytes(data), cls)
    except InterfaceError as error:
        raise unreadable(path, error) from None


def _rate_hz(text: str) -> float:
    """Convert a string to a rate in Hz. The error messages are those of ros2bag, which differ from other commands."""
    try:
        rate = float(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f'{text} is not the valid type (float)') from None
    if not 0 < rate < math.inf:
        raise argparse.ArgumentTypeError(f'{text} is not in the valid range (> 0.0)')
    return rate


def play_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options that select and remap topics, and that set the rate."""
    parser.add_argument('bag_path', type=existing_path, help='Bag to open')
    parser.add_argument(
        '-r', '--rate', type=_rate_hz, default=1.0, help='rate at which to play back messages. Valid range > 0.0.'
    )
    parser.add_argument('--topics', nargs='+', default=[], metavar='topic', help='Space-delimited list of topics to play.')
    parser.add_argument('--services', nargs='+', default=[], metavar='service', help='Space-delimited list of services to play.')
    parser.add_argument('--exclude-topics', nargs='+', default=[], metavar='topic', help='Topics that are not played.')
    parser.add_argument('--exclude-services', nargs='+', default=[], metavar='service', help='Services that are not played.')
    parser.add_argument('-e', '--regex', default='', help='Play only topics and services matching the regular expression.')
    parser.add_argument('-x', '--exclude-regex', default='', help='Do not play topics and services matching it.')
    parser.add_argument('-m', '--remap', nargs='+', default=[], metavar='old:=new', help='Play topics under other names.')
    parser.add_argument('-s', '--storage', metavar='ID', help='accepted; the storage is found out from the bag')
    parser.add_argument('--publish-service-requests', action='store_true', help='Send the recorded requests of services.')
    _add_play_times(parser)


def _add_play_times(parser: argparse.ArgumentParser) -> None:
    """Add the options for the start, the end, the repetition and the clock of the playback."""
    parser.add_argument(
        '--clock',
        type=_rate_hz,
        nargs='?',
        const=CLOCK_HZ,
        metavar='HZ',
        help=f'Publish to /clock at a rate in Hz, as the time of the simulation. (default: {CLOCK_HZ:g} when given)',
    )
    parser.add_argument(
        '--start-offset', type=float, default=0.0, help='Start the playback player this many seconds into the bag file.'
    )
    parser.add_argument('--playback-duration', type=float, default=-1.0, help='Playback duration, in seconds (default: all).')
    parser.add_argument('-l', '--loop', action='store_true', help='enables loop playback when playing a bagfile.')
    parser.add_argument('-d', '--delay', type=float, default=0.0, help='Sleep duration before play (each loop), in seconds.')
    parser.add_argument('-p', '--start-paused', action='store_true', help='Start the playback player in a paused state.')
    parser.add_argument('--disable-keyboard-controls', action='store_true', help='disables keyboard controls for playback.')
    parser.add_argument('--playback-until-sec', type=float, default=-1.0, help='Playback until the timestamp, in seconds.')
    parser.add_argument('--playback-until-nsec', type=int, default=-1, help='Playback until the timestamp, in nanoseconds.')
    parser.add_argument('--log-level', choices=LOG_LEVELS, default='info', help='Logging level.')
    for names, hint in ACCEPTED:
        parser.add_argument(*names, help=f'accepted; {hint}')
    parser.add_argument('--disable-loan-message', action='store_true', help='accepted; no message is loaned')


def play_verb(arguments: argparse.Namespace) -> None:
    """Publish each message at its time. End after the last message, or repeat the bag with `--loop`. SPACE pauses and resumes."""
    with cli_node.cli_node(name='rosbag2_player') as node:
        player = Player(node, arguments)
        player.load(arguments.bag_path)
        while player.messages and player.play_once() and arguments.loop:
            pass
