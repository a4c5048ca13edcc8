"""Parameter files made for one run: named the same in every run, and left in the temporary folder, as ROS 2 leaves them."""

from __future__ import annotations

import os
from typing import Any

Written = tuple[str, int]
"""Path and inode: the file is only removed while it is still the one that was written."""


def temporary_path(key: str, state: dict[str, Any]) -> str:
    """The path `launch_params_XXXXXXXX` in the temporary folder, for a file to be written later.

    The name is made from `key`, so that command lines (which are recorded) repeat from run to run. Two keys of
    one launch never get the same path.

    :param state: of the process that runs launch.
    """
    import tempfile
    import zlib

    digest = zlib.crc32(key.encode())
    keys: dict[int, str] = state.setdefault('launch_ros.parameter_files', {})
    while keys.setdefault(digest, key) != key:
        digest = zlib.crc32(b'another', digest)
    return f'{tempfile.gettempdir()}{os.sep}launch_params_{digest:08x}'


class TemporaryFiles:
    """Files that were written, and can be removed.

    Two runs at the same time may write the same file: each replaces it whole, with equal content. They are therefore not
    removed when a run ends: another may be about to read them.
    """

    def __init__(self) -> None:
        self._written: list[Written] = []

    def write(self, path: str, text: str) -> None:
        """Write a file, whole at once; one that an earlier run left with this text stays: to look takes a tenth of the time."""
        content = text.encode()
        if _content_of(path) != content:
            import tempfile

            handle, draft = tempfile.mkstemp(prefix='launch_params_')
            with open(handle, 'wb') as stream:
                stream.write(content)
            os.replace(draft, path)
        self._written.append((path, os.stat(path).st_ino))

    def remove(self) -> None:
        """Remove all of them."""
        _remove(self._written)


def _content_of(path: str) -> bytes | None:
    try:
        with open(path, 'rb', buffering=0) as stream:  # half the time of a text stream
            return stream.read()
    except OSError:
        return None


def _remove(written: list[Written]) -> None:
    while written:
        path, inode = written.pop()
        try:
            if os.stat(path).st_ino == inode:
                os.unlink(path)
        except OSError:
            continue  # gone already
