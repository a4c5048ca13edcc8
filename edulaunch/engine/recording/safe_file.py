"""Writes a file, either completely or not at all. An older file with the same path stays until the new file is safe on the
disk.
"""

from __future__ import annotations

import errno
import glob
import os
from collections.abc import Iterable
from contextlib import suppress
from typing import BinaryIO

NO_SUCH_CALL = (errno.EINVAL, errno.ENOTSUP)
"""Errors of file systems that do not support `fsync`."""


def write_safely(path: str | os.PathLike[str], lines: Iterable[bytes]) -> None:
    """Write lines to a file. A path that is not a regular file (`/dev/stdout`, a pipe) is written to directly.

    The lines are first written to a draft with a unique name, so that two programs can write the same file at the same time.
    When the draft is safe on the disk, it replaces the file. If an error occurs, the draft is removed, and the older file
    stays.

    :raises OSError: if the file cannot be written.
    """
    target = os.path.realpath(path)
    if os.path.exists(target) and not os.path.isfile(target):
        with open(target, 'wb') as stream:
            stream.writelines(lines)
        return
    remove_drafts(target)
    draft = f'{_stem(target)}{os.getpid()}-{os.urandom(4).hex()}.part'
    try:
        with open(draft, 'xb') as file:
            with suppress(OSError, ImportError):
                _lock(file)
            file.writelines(lines)
            file.flush()
            _sync(file.fileno())
            os.replace(draft, target)
    except BaseException:
        with suppress(OSError):
            os.unlink(draft)
        raise
    _sync_folder(os.path.dirname(target))


def remove_drafts(path: str | os.PathLike[str]) -> None:
    """Remove the drafts of a file that killed programs have left. Drafts that a running program is writing stay."""
    for draft in glob.glob(f'{glob.escape(_stem(os.path.realpath(path)))}*.part'):
        with suppress(OSError, ImportError), open(draft, 'rb') as file:
            _lock(file)
            os.unlink(draft)


def _stem(target: str) -> str:
    """Return the common prefix of all drafts of a file. It is short enough for file systems with a limit of 255 bytes."""
    folder, name = os.path.split(target)
    return os.path.join(folder, f'.{os.fsdecode(os.fsencode(name)[:200])}.')


def _lock(file: BinaryIO) -> None:
    """Lock a draft until its file is closed.

    :raises OSError: if another process has locked the draft, or the file system has no locks.
    :raises ImportError: if this operating system has no locks.
    """
    import fcntl

    fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)


def _sync(descriptor: int) -> None:
    try:
        os.fsync(descriptor)
    except OSError as error:
        if error.errno not in NO_SUCH_CALL:
            raise


def _sync_folder(folder: str) -> None:
    """Write the folder to the disk, so that the new name survives a power cut. The content of the file is already on the disk.

    Do nothing on operating systems that cannot open folders.
    """
    with suppress(OSError):
        descriptor = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(descriptor)
        finally:
            os.close(descriptor)
