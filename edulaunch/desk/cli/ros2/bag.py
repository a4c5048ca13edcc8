"""`ros2 bag info`, functions that find and read bags with `rosbags`, and the keys that control a recording or a playback."""

from __future__ import annotations

import argparse
import os
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from edulaunch.desk.cli.ros2.bag_metadata import read_metadata, unreadable
from edulaunch.desk.cli.ros2.output import say, say_lines, with_help
from edulaunch.engine.processes.current import current_process
from edulaunch.errors import MissingExtra

EVENT_TOPIC, EVENT_TYPE = '/_service_event', '_Event'
"""The endings of the name and of the type of the topic with a service's events."""
NO_BAG = 'give the folder that `ros2 bag record` created'
RESPONSE_SENT = 2
CALL = slice(16, 44)
"""The bytes of a serialized service event that identify a call: the id of the client and the number of the request."""
WIDTH = 19
LOG_LEVELS = ('debug', 'info', 'warn', 'error', 'fatal')
SORTED_BY: dict[str, Callable[[dict[str, Any]], Any]] = {
    'name': lambda entry: entry['topic_metadata']['name'],
    'type': lambda entry: entry['topic_metadata']['type'],
    'count': lambda entry: entry['message_count'],
}


def set_level(logger: Any, word: str) -> None:
    """Set the level of a logger.

    :param word: the lowest level that the logger shows, one of `LOG_LEVELS`.
    """
    from rclpy.logging import get_logging_severity_from_string

    logger.set_level(get_logging_severity_from_string(word))


def folder_of(path: str) -> str:
    """Return the absolute path of a bag. The given path is relative to the folder in which the command runs."""
    return os.path.abspath(os.path.join(current_process().cwd or '', path))


def existing_path(text: str) -> str:
    """Return the path of a bag as the user typed it.

    :raises ArgumentTypeError: when there is no such path, with the message of ROS 2.
    """
    if not os.path.exists(folder_of(text)):
        raise argparse.ArgumentTypeError(with_help(f"Bag path '{text}' does not exist!", NO_BAG))
    return text


def new_folder() -> str:
    """Return the path of a new folder.

    As in ROS 2, its name contains the date and the time, and a number if the folder exists.
    """
    name = folder_of(time.strftime('rosbag2_%Y_%m_%d-%H_%M_%S'))
    numbered = (f'{name}_{number}' for number in range(1, 1_000_000))
    return name if not os.path.exists(name) else next(other for other in numbered if not os.path.exists(other))


def found_bag(path: str) -> str:
    """Return the folder of a bag.

    :param path: the path of this folder, or of a file in it.
    :raises RuntimeError: when there is no bag.
    """
    folder = folder_of(path)
    if os.path.isfile(folder):
        folder = os.path.dirname(folder)
    if os.path.isfile(os.path.join(folder, 'metadata.yaml')):
        return folder
    raise RuntimeError(with_help(f"[ERROR] [ros2bag]: '{path}' has no metadata.yaml", NO_BAG))


def require_rosbags() -> None:
    """Check that the package rosbags, which reads and writes bags, is installed.

    :raises MissingExtra: when rosbags is not installed.
    """
    if find_spec('rosbags') is None:
        raise MissingExtra('ros2 bag', 'rosbags', 'bags')


@contextmanager
def opened(path: str) -> Iterator[Any]:
    """Open the bag at `path` for a `with` statement, which receives the reader of rosbags.

    :raises MissingExtra: when rosbags is not installed.
    :raises RuntimeError: when there is no bag, or the bag cannot be read.
    """
    require_rosbags()
    from rosbags.rosbag2 import Reader

    folder = found_bag(path)
    read_metadata(path, folder)
    try:
        reader = Reader(Path(folder))
        reader.open()
    except Exception as error:  # the type of error depends on the storage format
        raise unreadable(path, error) from None
    try:
        yield reader
    finally:
        reader.close()


def messages_of(path: str, reader: Any, **span: Any) -> Iterator[Any]:
    """Yield the messages of an open bag as (connection, time in nanoseconds, bytes).

    :param path: the name of the bag for error messages.
    :param reader: the reader that `opened` provides.
    :param span: the start and stop time in nanoseconds, if only some messages are wanted.
    :raises RuntimeError: when the file is damaged.
    """
    rows = reader.messages(**span)
    while True:
        try:
            row = next(rows)
        except StopIteration:
            return
        except Exception as error:  # the type of error depends on the storage format
            raise unreadable(path, error) from None
        yield row


def event_kind(data: bytes) -> int:
    """Return the event type of a serialized service event.

    0 means request sent, 1 request received, 2 response sent, and 3 response received.
    """
    return data[4]  # the first four bytes describe the encoding


def info_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the argument for the bag, and the options that choose what to print."""
    parser.add_argument('bag_path', type=existing_path, help='Bag to open')
    parser.add_argument('-t', '--topic-name', action='store_true', help='Only display topic names.')
    parser.add_argument('-v', '--verbose', action='store_true', help='Display request/response information for services')
    parser.add_argument('--sort', choices=tuple(SORTED_BY), default='name', help='Configuration for sorting of output.')
    parser.add_argument('-s', '--storage', metavar='ID', help='accepted; the storage is found out from the bag')


def info_verb(arguments: argparse.Namespace) -> None:
    """Print the summary of a bag: its files, its times, and the number of messages of each topic and of events of each
    service.
    """
    folder = found_bag(arguments.bag_path)
    content = read_metadata(arguments.bag_path, folder)
    content['topics_with_message_count'].sort(key=SORTED_BY[arguments.sort])
    if arguments.topic_name and arguments.verbose:
        say("Warning! You have set both the '-t' and '-v' parameters. The '-t' parameter will be ignored.")
    if arguments.topic_name and not arguments.verbose:
        say_lines([each['topic_metadata']['name'] for each in content['topics_with_message_count']])
    else:
        calls = _calls(arguments.bag_path) if arguments.verbose else None
        say_lines(_lines(folder, content, calls))


def _calls(path: str) -> dict[str, tuple[int, int]]:
    """Return the numbers of requests and responses for each topic with service events.

    Client and server both record a call, so each call is counted once.
    """
    seen: dict[str, tuple[set[bytes], set[bytes]]] = {}
    with opened(path) as reader:
        events = [each for each in reader.connections if each.topic.endswith(EVENT_TOPIC)]
        for connection, _, data in messages_of(path, reader, connections=events) if events else ():
            is_response = event_kind(data) >= RESPONSE_SENT
            seen.setdefault(connection.topic, (set(), set()))[is_response].add(bytes(data[CALL]))
    return {topic: (len(requests), len(responses)) for topic, (requests, responses) in seen.items()}


def _lines(folder: str, content: dict[str, Any], calls: dict[str, tuple[int, int]] | None) -> list[str]:
    files = content['relative_file_paths']
    size = sum(os.path.getsize(os.path.join(folder, name)) for name in files)
    start, length = content['starting_time']['nanoseconds_since_epoch'], content['duration']['nanoseconds']
    if not content['message_count']:  # without messages, the times are the largest possible numbers
        start = length = 0
    listed = content['topics_with_message_count']
    events = [each for each in listed if each['topic_metadata']['name'].endswith(EVENT_TOPIC)]
    topics = [each for each in listed if each not in events]
    rows = (
        ('Files:', '\n'.join(files)),
        ('Bag size:', _size(size)),
        ('Storage id:', content['storage_identifier']),
        ('ROS Distro:', content.get('ros_distro') or 'unknown'),
        ('Duration:', f'{_seconds(length)}s'),
        ('Start:', _moment(start)),
        ('End:', _moment(start + length)),
        ('Messages:', str(content['message_count'])),
        ('Topic information:', '\n'.join(f'Topic: {_described(each, _count(each))}' for each in topics)),
        ('Service:', str(len(events))),
        ('Service information:', '\n'.join(f'Service: {_described(each, _events(each, calls))}' for each in events)),
    )
    return ['', *(f'{name:<{WIDTH}}{text}'.replace('\n', '\n' + ' ' * WIDTH) for name, text in rows)]


def _count(entry: dict[str, Any]) -> str:
    return f'Count: {entry["message_count"]}'


def _events(entry: dict[str, Any], calls: dict[str, tuple[int, int]] | None) -> str:
    if calls is None:
        return f'Event {_count(entry)}'
    requests, responses = calls.get(entry['topic_metadata']['name'], (0, 0))
    return f'Request Count: {requests} | Response Count: {responses}'


def _described(entry: dict[str, Any], count: str) -> str:
    about = entry['topic_metadata']
    return (
        f'{about["name"].removesuffix(EVENT_TOPIC)} | Type: {about["type"].removesuffix(EVENT_TYPE)} | '
        f'{count} | Serialization Format: {about["serialization_format"]}'
    )


def _size(size: float) -> str:
    for unit in ('B', 'KiB', 'MiB', 'GiB'):
        if size < 1024 or unit == 'GiB':
            break
        size /= 1024
    return f'{size:.0f} {unit}' if unit == 'B' else f'{size:.1f} {unit}'


def _seconds(nanoseconds: int) -> str:
    return f'{nanoseconds // 1_000_000_000}.{nanoseconds % 1_000_000_000:09}'


def _moment(nanoseconds: int) -> str:
    from datetime import datetime, timezone

    moment = datetime.fromtimestamp(nanoseconds // 1_000_000_000, timezone.utc)
    return f'{moment:%b %d %Y %H:%M:%S}.{nanoseconds % 1_000_000_000:09} ({_seconds(nanoseconds)})'


class Keys:
    """Reads pressed keys from the terminal without waiting.

    The terminal sends each key immediately. `close` restores the previous mode of the terminal.
    """

    def __init__(self) -> None:
        process = current_process()
        self._input: Any = process.streams.stdin
        self._is_over = False
        if self._input.isatty():
            tty: Any = process.loader.import_module('tty')
            tty.setcbreak(0)

    def pressed(self) -> str:
        """Return the keys that the user has pressed since the last call."""
        keys = ''
        while not self._is_over and self._input.is_ready():
            key = self._input.read(1)
            self._is_over = not key
            keys += key
        return keys
