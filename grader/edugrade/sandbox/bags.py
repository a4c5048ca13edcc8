"""Compares the bags that a run has written with the messages that were published in the run.

The confined process of the run reads the bags. A bag is a student's file, so it may contain anything. This module opens only
a few small regular files, and unpickles nothing. If reading still takes too much time or memory, the limits end the run as
usual.
"""

from __future__ import annotations

import os
import stat
from collections import Counter
from collections.abc import Callable, Iterator
from typing import Any

METADATA = 'metadata.yaml'
MOST_BAGS, MOST_FILES, MOST_TOPICS, MOST_MESSAGES = 4, 16, 200, 100_000
MOST_BYTES, MOST_METADATA_BYTES = 32 << 20, 1 << 18
LONGEST_NAME = 256
Published = Callable[[str], 'Counter[bytes]']


def written_bags(home: str, end_ns: int, published: Published) -> list[dict[str, Any]]:
    """Read the bags below a folder, in the order of their paths.

    :param home: the folder of a run.
    :param end_ns: the simulated time in ns; later messages do not count.
    :param published: a function that returns how often each message, as CDR bytes, was published on a topic.
    :return: for each bag `folder` and `topics`. For each topic, `topics` has the number of messages in the bag. A second number
        states how many of these messages were published in the run. A bag that cannot be read has no topics.
    """
    return [
        {'folder': os.path.relpath(folder, home)[:LONGEST_NAME], 'topics': _topics(folder, end_ns, published)}
        for folder in _folders(home)
    ]


def _folders(home: str) -> list[str]:
    found: list[str] = []
    for folder, inner, files in os.walk(home):
        inner.sort()
        if METADATA in files and len(found) < MOST_BAGS:
            found.append(folder)
    return found


def _topics(folder: str, end_ns: int, published: Published) -> dict[str, list[int]]:
    try:
        _refuse_odd_files(folder)
        return _counted(_messages(folder), end_ns, published)
    except MemoryError:
        raise
    except Exception:  # hostile bytes can make the reader raise any exception; all of them mean the same
        return {}


def _refuse_odd_files(folder: str) -> None:
    """Raise an error for a directory that is not a bag, or is too large."""
    import yaml

    states = {name: os.lstat(os.path.join(folder, name)) for name in os.listdir(folder)}
    sizes = [state.st_size for state in states.values()]
    if len(states) > MOST_FILES or sum(sizes) > MOST_BYTES or states[METADATA].st_size > MOST_METADATA_BYTES:
        raise ValueError('too large')
    if not all(stat.S_ISREG(state.st_mode) for state in states.values()):
        raise ValueError('not only files')
    with open(os.path.join(folder, METADATA), 'rb') as file:
        content = yaml.safe_load(file.read(MOST_METADATA_BYTES))['rosbag2_bagfile_information']
    if content.get('compression_mode') or not set(content['relative_file_paths']) <= set(states):
        raise ValueError('compressed, or files of another folder')


def _messages(folder: str) -> Iterator[tuple[str, int, bytes]]:
    from pathlib import Path

    from rosbags.rosbag2 import Reader

    with Reader(Path(folder)) as reader:
        for connection, time_ns, data in reader.messages():
            yield connection.topic, time_ns, bytes(data)


def _counted(messages: Iterator[tuple[str, int, bytes]], end_ns: int, published: Published) -> dict[str, list[int]]:
    counts: dict[str, list[int]] = {}
    left: dict[str, Counter[bytes]] = {}
    for number, (topic, time_ns, data) in enumerate(messages):
        if number >= MOST_MESSAGES or len(topic) > LONGEST_NAME or len(counts) > MOST_TOPICS:
            raise ValueError('too much')
        if time_ns > end_ns:
            continue
        if topic not in left:
            left[topic], counts[topic] = published(topic), [0, 0]
        counts[topic][0] += 1
        if left[topic][data] > 0:
            left[topic][data] -= 1
            counts[topic][1] += 1
    return counts
