"""Read the `metadata.yaml` of a bag. A schema checks the file, so callers can trust the content of any bag."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import Any

from edulaunch.desk.cli.ros2.output import with_help
from edulaunch.engine.recording.schema import Check, each, number, text

ROOT = 'rosbag2_bagfile_information'
LONGEST_BYTES = 10_000_000
_HELP = 'give a bag that `ros2 bag record` created, or record it again'


def _count(value: Any) -> bool:
    return number(value) and value >= 0


def _inside(value: Any) -> bool:
    """Return whether a value is a path inside the bag's own folder."""
    return text(value) and '\0' not in value and not os.path.isabs(value) and '..' not in value.split('/')


SCHEMA: dict[str, tuple[Check, str]] = {
    'storage_identifier': (text, 'a text'),
    'relative_file_paths': (each(_inside), 'a list of files in the folder of the bag'),
    'message_count': (_count, 'a whole number'),
    'starting_time.nanoseconds_since_epoch': (number, 'a whole number'),
    'duration.nanoseconds': (_count, 'a whole number'),
    'topics_with_message_count': (each(lambda row: type(row) is dict), 'a list of topics'),
}
TOPIC: dict[str, tuple[Check, str]] = {
    'message_count': (_count, 'a whole number'),
    'topic_metadata.name': (text, 'a text'),
    'topic_metadata.type': (text, 'a text'),
    'topic_metadata.serialization_format': (text, 'a text'),
}


def unreadable(path: str, why: object) -> RuntimeError:
    """Return the error to raise for a bag that cannot be read."""
    reason = ' '.join(str(why).split())[:200] or type(why).__name__
    return RuntimeError(with_help(f"[ERROR] [ros2bag]: '{path}' cannot be read: {reason}", _HELP))


def read_metadata(path: str, folder: str) -> dict[str, Any]:
    """Return the metadata of the bag in a folder.

    :param path: the path that the user typed, for error messages.
    :param folder: the folder of the bag.
    :raises RuntimeError: when the metadata are invalid. The message names the wrong entry.
    """
    import yaml

    file = os.path.join(folder, 'metadata.yaml')
    try:
        if os.path.getsize(file) > LONGEST_BYTES:
            raise unreadable(path, f'metadata.yaml is longer than {LONGEST_BYTES} bytes')
        with open(file, encoding='utf-8') as stream:
            content = yaml.safe_load(stream)
    except (OSError, ValueError, TypeError, RecursionError, yaml.YAMLError) as error:
        raise unreadable(path, f'metadata.yaml: {error}') from None
    found = content.get(ROOT) if type(content) is dict else None
    if type(found) is not dict:
        raise unreadable(path, f'metadata.yaml has no mapping {ROOT}')
    for problem in (*_problems(found, SCHEMA), *_topic_problems(found), *_absent(folder, found)):
        raise unreadable(path, f'metadata.yaml: {problem}')
    return found


def _problems(content: dict[str, Any], schema: dict[str, tuple[Check, str]]) -> Iterator[str]:
    for name, (check, expected) in schema.items():
        value: Any = content
        for key in name.split('.'):
            value = value.get(key) if type(value) is dict else None
        if not check(value):
            yield f'{name} is not {expected}'
            return


def _topic_problems(content: dict[str, Any]) -> Iterator[str]:
    rows = content.get('topics_with_message_count')
    for index, row in enumerate(rows if type(rows) is list else ()):
        yield from (f'topic {index + 1}: {problem}' for problem in (_problems(row, TOPIC) if type(row) is dict else ()))


def _absent(folder: str, content: dict[str, Any]) -> Iterator[str]:
    names = content.get('relative_file_paths')
    for name in names if type(names) is list else ():
        if text(name) and '\0' not in name and not os.path.isfile(os.path.join(folder, name)):
            yield f'its file {name!r} is missing'
