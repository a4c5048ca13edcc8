"""`edulaunch recording export`: the messages of a recording as a rosbag2 bag, or as tables."""

from __future__ import annotations

import argparse
import os
from collections.abc import Iterator
from typing import Any

from edulaunch.errors import UnusableInput
from edulaunch.graph.qos import QoS
from edulaunch.recording import Recording
from edulaunch.sourcing import source


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Which form, and where."""
    parser.add_argument('file', metavar='FILE', help='a recording')
    form = parser.add_mutually_exclusive_group(required=True)
    form.add_argument('--bag', metavar='FOLDER', nargs='?', const='', help='as a bag for `ros2 bag` (default: FILE_bag)')
    form.add_argument('--csv', metavar='FOLDER', nargs='?', const='', help='one table for each topic (default: FILE_csv)')
    parser.add_argument('--topics', nargs='+', metavar='TOPIC', help='only these topics')
    parser.add_argument('--storage', choices=('mcap', 'sqlite3'), default='mcap', help='of the bag (default: mcap)')


def export(arguments: argparse.Namespace) -> int:
    """Write it, and print where it is; 0 when that went well.

    :raises UnusableInput: when the folder is there already, or cannot be made.
    """
    source()
    recording = Recording.load(arguments.file)
    stem = os.path.splitext(arguments.file)[0]
    folder = (arguments.bag or f'{stem}_bag') if arguments.bag is not None else (arguments.csv or f'{stem}_csv')
    if os.path.exists(folder):
        raise UnusableInput(f'{folder} is there already', help='name a new folder, or remove it')
    names = [name for name, topic in recording.topics.items() if topic.count]
    for name in arguments.topics or ():
        if name not in names:
            raise UnusableInput(f'nothing was published on {name}', help=f'topics: {", ".join(names)}')
    chosen = arguments.topics or names
    try:
        if arguments.bag is not None:
            _write_bag(recording, folder, arguments.storage, chosen)
        else:
            _write_tables(recording, folder, chosen)
    except OSError as error:
        raise UnusableInput(f'{folder} cannot be written: {error.strerror}') from None
    print(folder)
    return 0


def _write_bag(recording: Recording, folder: str, storage: str, names: list[str]) -> None:
    """The messages at the times when they were published; of a topic with several types those of the first."""
    from edulaunch.cli.ros2.bag.writing import write_bag

    topics = [_Topic(name, type(recording.messages(name)[0][1]), recording.offered(name)) for name in names]
    messages = [
        (recording.start_ns + time_ns, topic.name, wire)
        for topic in topics
        for time_ns, wire in recording.wires(topic.name, topic.cls.TYPE)
    ]
    write_bag(folder, storage, topics, sorted(messages, key=lambda message: message[0]), recording.registry)


class _Topic:
    """One topic of the bag, with its class and the quality of service of its publishers."""

    def __init__(self, name: str, cls: Any, offered: list[QoS]) -> None:
        self.name, self.cls, self.offered = name, cls, offered


def _write_tables(recording: Recording, folder: str, names: list[str]) -> None:
    """A file `turtle1.pose.csv` for the topic /turtle1/pose: seconds, and a column for each number or text of the message."""
    import csv

    os.makedirs(folder)
    for name in names:
        rows = [(time_s, dict(_cells(message))) for time_s, message in recording.messages(name)]
        columns = list(dict.fromkeys(column for _, cells in rows for column in cells))
        with open(os.path.join(folder, name.strip('/').replace('/', '.') + '.csv'), 'w', encoding='utf-8', newline='') as file:
            table = csv.writer(file)
            table.writerow(['time', *columns])
            table.writerows([f'{time_s:.9f}', *(cells.get(column, '') for column in columns)] for time_s, cells in rows)


def _cells(value: Any, path: str = '') -> Iterator[tuple[str, Any]]:
    """Path and value of each number or text in a message, such as ('linear.x', 2.0)."""
    fields = getattr(value, 'get_fields_and_field_types', None)
    if fields is not None:
        for name in fields():
            yield from _cells(getattr(value, name), f'{path}.{name}' if path else name)
    elif hasattr(value, '__iter__') and not isinstance(value, (str, bytes)):
        for number, item in enumerate(value):
            yield from _cells(item, f'{path}.{number}')
    else:
        yield path, value
