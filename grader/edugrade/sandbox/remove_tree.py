"""Removes a folder, whatever content a hostile program has created in it."""

from __future__ import annotations

import os
from contextlib import suppress


def remove_tree(folder: str) -> None:
    """Remove a folder with everything in it, as far as possible.

    Folders that are nested too deeply for a path or the stack are first moved up, and missing permissions are added. Links
    are removed without following them.
    """
    moved = 0
    pending = [folder]
    while pending:
        inside = pending[-1]
        with suppress(OSError):
            os.chmod(inside, 0o700)
        for name in _names(inside):
            path = os.path.join(inside, name)
            with suppress(OSError):
                if os.path.islink(path) or not os.path.isdir(path):
                    os.unlink(path)
                elif inside == folder:
                    pending.append(path)
                else:
                    os.chmod(path, 0o700)  # moving a folder changes its `..`, for which it must be writable
                    moved += 1
                    above = os.path.join(folder, f'.moved-{os.getpid()}-{moved}')
                    os.rename(path, above)
                    pending.append(above)
        if pending[-1] == inside:
            pending.pop()
            with suppress(OSError):
                os.rmdir(inside)


def _names(folder: str) -> list[str]:
    try:
        return os.listdir(folder)
    except OSError:
        return []
