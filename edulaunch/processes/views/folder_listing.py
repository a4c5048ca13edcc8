"""`os.scandir` in a program that has a working folder of its own: the entries' paths begin as the program wrote the folder."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import Any


class Entry:
    """An `os.DirEntry` of a folder that was given relative to the program's own one."""

    __slots__ = ('_entry', 'path')

    def __init__(self, entry: Any, path: Any) -> None:
        self._entry = entry
        self.path = path

    def __getattr__(self, name: str) -> Any:
        return getattr(self._entry, name)

    def __fspath__(self) -> Any:
        return self.path

    def __repr__(self) -> str:
        return repr(self._entry)


class Listing:
    """What `os.scandir` gives: an iterator that can be closed.

    :param shown: the folder as the program wrote it.
    :param folder: where it is.
    """

    def __init__(self, shown: Any, folder: Any) -> None:
        self._shown = os.fspath(shown)
        self._entries = os.scandir(folder)

    def __iter__(self) -> Iterator[Entry]:
        return self

    def __next__(self) -> Entry:
        entry = next(self._entries)
        return Entry(entry, os.path.join(self._shown, entry.name))

    def __enter__(self) -> Listing:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Stop before the end."""
        self._entries.close()
