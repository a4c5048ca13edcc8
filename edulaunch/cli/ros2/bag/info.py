"""`ros2 bag info`: what a bag holds."""

from __future__ import annotations

import argparse
import os
from typing import Any

from edulaunch.cli.ros2.bag.storage import EVENT_TOPIC, EVENT_TYPE, found_bag
from edulaunch.cli.ros2.names import say_lines

WIDTH = 19


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The bag, and how much to say of it."""
    parser.add_argument('bag_path', help='Bag to open')
    parser.add_argument('-t', '--topic-name', action='store_true', help='Only display topic names.')


def main(arguments: argparse.Namespace) -> None:
    """Print the summary: files, times, the messages of each topic and the events of each service."""
    import yaml

    folder = found_bag(arguments.bag_path)
    with open(os.path.join(folder, 'metadata.yaml'), encoding='utf-8') as file:
        content = yaml.safe_load(file)['rosbag2_bagfile_information']
    if arguments.topic_name:
        say_lines([each['topic_metadata']['name'] for each in content['topics_with_message_count']])
    else:
        say_lines(_lines(folder, content))


def _lines(folder: str, content: dict[str, Any]) -> list[str]:
    files = content['relative_file_paths']
    size = sum(os.path.getsize(os.path.join(folder, name)) for name in files)
    start, length = content['starting_time']['nanoseconds_since_epoch'], content['duration']['nanoseconds']
    if not content['message_count']:  # the times of nothing are the largest numbers there are
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
        ('Topic information:', '\n'.join(f'Topic: {_described(each, "Count")}' for each in topics)),
        ('Service:', str(len(events))),
        ('Service information:', '\n'.join(f'Service: {_described(each, "Event Count")}' for each in events)),
    )
    return ['', *(f'{name:<{WIDTH}}{text}'.replace('\n', '\n' + ' ' * WIDTH) for name, text in rows)]


def _described(entry: dict[str, Any], count: str) -> str:
    about = entry['topic_metadata']
    return (
        f'{about["name"].removesuffix(EVENT_TOPIC)} | Type: {about["type"].removesuffix(EVENT_TYPE)} | '
        f'{count}: {entry["message_count"]} | Serialization Format: {about["serialization_format"]}'
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
