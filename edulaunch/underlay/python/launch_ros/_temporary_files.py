"""Parameter files made for one run: named the same in every run, and removed with their owner."""

from __future__ import annotations

import os
import weakref
from collections.abc import Callable

from launch._engine import process_state

Written = tuple[str, int]
"""Path and inode: the file is only removed while it is still the one that was written."""


class TemporaryFiles:
    """Files `launch_params_XXXXXXXX` in the temporary folder.

    The name is made from the content, the owner and a count, so that command lines (which are recorded)
    repeat from run to run.
    Two runs at the same time may write the same file: each replaces it whole, with equal content.

    :param owner: a text that tells apart the owners in one run.
    """

    def __init__(self, owner: str = '') -> None:
        self._owner = owner
        self._count = 0
        self._promised: list[tuple[str, Callable[[], str]]] = []
        self._written: list[Written] = []

    def write(self, text: str) -> str:
        """Write a new file; gives its path."""
        path = self.promise(text, lambda: text)
        self.keep_promises()
        return path

    def promise(self, content: str, make: Callable[[], str]) -> str:
        """The path of a file that stands there after :meth:`keep_promises`.

        Writing takes longer than everything else that a launch file asks for, and most dry runs need no file.

        :param content: any text that differs when the file's text does.
        :param make: gives the file's text.
        """
        import tempfile
        import zlib

        key = f'{self._owner}\n{self._count}\n{content}'
        self._count += 1
        digest = zlib.crc32(key.encode())
        keys: dict[int, str] = process_state('launch_ros.parameter_files', dict)
        while keys.setdefault(digest, key) != key:
            digest = zlib.crc32(b'another', digest)
        path = f'{tempfile.gettempdir()}{os.sep}launch_params_{digest:08x}'
        self._promised.append((path, make))
        return path

    def keep_promises(self) -> None:
        """Write what was promised."""
        promised, self._promised = self._promised, []
        for path, make in promised:
            self._write(path, make())

    def _write(self, path: str, text: str) -> None:
        import tempfile

        handle, draft = tempfile.mkstemp(prefix='launch_params_')
        with open(handle, 'w', encoding='utf-8') as stream:
            stream.write(text)
        os.replace(draft, path)
        if not self._written:
            weakref.finalize(self, _remove, self._written)
        self._written.append((path, os.stat(path).st_ino))

    def remove(self) -> None:
        """Remove all of them."""
        _remove(self._written)


def _remove(written: list[Written]) -> None:
    while written:
        path, inode = written.pop()
        try:
            if os.stat(path).st_ino == inode:
                os.unlink(path)
        except OSError:
            continue  # gone already
