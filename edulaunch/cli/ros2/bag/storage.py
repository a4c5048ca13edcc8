"""Where bags lie, and reading them with `rosbags`."""

from __future__ import annotations

import os
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from edulaunch.cli.ros2.output import with_help
from edulaunch.processes.current import current_process

EVENT_TOPIC, EVENT_TYPE = '/_service_event', '_Event'
"""How the topic of a service's events, and its type, end."""


def folder_of(path: str) -> str:
    """The absolute path of a bag that is named on the command line."""
    return os.path.abspath(os.path.join(current_process().cwd or '', path))


def new_folder() -> str:
    """A folder that is not there yet, named after date and time of day as in ROS 2; several of one second are numbered."""
    name = folder_of(time.strftime('rosbag2_%Y_%m_%d-%H_%M_%S'))
    numbered = (f'{name}_{number}' for number in range(1, 1_000_000))
    return name if not os.path.exists(name) else next(other for other in numbered if not os.path.exists(other))


def found_bag(path: str) -> str:
    """The folder of the bag at `path`, which is that folder or a file in it.

    :raises RuntimeError: when there is no bag; begins with the words of ROS 2.
    """
    folder = folder_of(path)
    if os.path.isfile(folder):
        folder = os.path.dirname(folder)
    if os.path.isfile(os.path.join(folder, 'metadata.yaml')):
        return folder
    text = f"'{path}' has no metadata.yaml" if os.path.exists(folder) else f"bag path '{path}' does not exist!"
    raise RuntimeError(with_help(f'[ERROR] [ros2bag]: {text}', 'give the folder that `ros2 bag record` made'))


@contextmanager
def opened(path: str) -> Iterator[Any]:
    """The reader of the bag at `path`.

    :raises RuntimeError: when there is no bag, or one that cannot be read.
    """
    from rosbags.rosbag2 import Reader, ReaderError

    try:
        with Reader(Path(found_bag(path))) as reader:
            yield reader
    except ReaderError as error:
        raise RuntimeError(f"[ERROR] [ros2bag]: '{path}' cannot be read: {error}") from None


def event_kind(data: bytes) -> int:
    """What a serialized service event tells: 0 request sent, 1 request received, 2 response sent, 3 response received."""
    return data[4]  # behind the four bytes that say how it is encoded
