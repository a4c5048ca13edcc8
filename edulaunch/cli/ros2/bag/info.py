"""`ros2 bag info`: what a bag holds."""

from __future__ import annotations

import argparse
import os
from typing import Any

from edulaunch.cli.ros2.names import say_lines
from edulaunch.cli.ros2.output import with_help
from edulaunch.processes.current import current_process

WIDTH = 19


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """As in ROS 2."""
    parser.add_argument('bag_path', help='Bag to open')


def main(arguments: argparse.Namespace) -> str | None:
    """Print the summary that its metadata.yaml gives."""
    import yaml

    folder = os.path.join(current_process().spec.cwd or '', arguments.bag_path)
    path = os.path.join(folder, 'metadata.yaml')
    if not os.path.isfile(path):
        return with_help(
            f"[ERROR] [ros2bag]: bag path '{arguments.bag_path}' does not exist!"
            if not os.path.exists(folder)
            else f"[ERROR] [ros2bag]: '{arguments.bag_path}' has no metadata.yaml",
            'give the folder that `ros2 bag record` made',
        )
    with open(path, encoding='utf-8') as file:
        content = yaml.safe_load(file)['rosbag2_bagfile_information']
    say_lines(_lines(folder, content))
    return None


def _lines(folder: str, content: dict[str, Any]) -> list[str]:
    files = content['relative_file_paths']
    size = sum(os.path.getsize(os.path.join(folder, name)) for name in files)
    start, length = content['starting_time']['nanoseconds_since_epoch'], content['duration']['nanoseconds']
    topics = [_topic_line(each) for each in content['topics_with_message_count']]
    rows = (
        ('Files:', '\n'.join(files)),
        ('Bag size:', _size(size)),
        ('Storage id:', content['storage_identifier']),
        ('ROS Distro:', content.get('ros_distro') or 'unknown'),
        ('Duration:', f'{_seconds(length)}s'),
        ('Start:', _moment(start)),
        ('End:', _moment(start + length)),
        ('Messages:', str(content['message_count'])),
        ('Topic information:', '\n'.join(topics)),
        ('Service:', '0'),
    )
    return ['', *(f'{name:<{WIDTH}}{text}'.replace('\n', '\n' + ' ' * WIDTH) for name, text in rows), 'Service information: ']


def _topic_line(entry: dict[str, Any]) -> str:
    about = entry['topic_metadata']
    return (
        f'Topic: {about["name"]} | Type: {about["type"]} | Count: {entry["message_count"]} | '
        f'Serialization Format: {about["serialization_format"]}'
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
