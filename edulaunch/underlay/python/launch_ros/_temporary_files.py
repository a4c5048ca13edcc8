"""Parameter files made for one run: named the same in every run, and removed with their owner."""

from __future__ import annotations

import os
import weakref

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
        self._written: list[Written] = []
        self._finalizer = weakref.finalize(self, _remove, self._written)

    def write(self, text: str) -> str:
        """Write a new file; gives its path."""
        import hashlib
        import tempfile

        digest = hashlib.sha256(f'{self._owner}\n{len(self._written)}\n{text}'.encode()).hexdigest()[:8]
        path = os.path.join(tempfile.gettempdir(), f'launch_params_{digest}')
        handle, draft = tempfile.mkstemp(prefix='launch_params_')
        with open(handle, 'w', encoding='utf-8') as stream:
            stream.write(text)
        os.replace(draft, path)
        self._written.append((path, os.stat(path).st_ino))
        return path

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
