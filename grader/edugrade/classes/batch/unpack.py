"""Unpacks untrusted archives: only regular files and folders, only inside the given folder, and within limits on the
measured size.
"""

from __future__ import annotations

import bz2
import gzip
import io
import os
import stat
import tarfile
import zipfile
import zlib
from collections.abc import Iterator
from typing import BinaryIO, NamedTuple

from edulaunch.errors import UnusableInput

MEBI = 1 << 20
CHUNK = 1 << 16
DEEPEST = 30  # levels of folders
LONGEST_PART, LONGEST_NAME = 200, 1000  # in bytes
ENTRY_BYTES = 300  # largest average size of a file's entry in the directory of a zip file
HIGHEST_RATIO, RATIO_FROM = 200, MEBI  # unpacked size divided by packed size; small files may exceed this ratio
END_OF_ZIP = b'PK\x05\x06'


class Bounds(NamedTuple):
    """The limits of an archive: the number of files, the unpacked bytes, and the packed bytes."""

    files: int
    unpacked: int
    packed: int


OF_A_STUDENT = Bounds(5000, 100 * MEBI, 50 * MEBI)
OF_A_CLASS = Bounds(200_000, 4096 * MEBI, 4096 * MEBI)


class Member(NamedTuple):
    """An entry in the list of an archive. `kind` is 'file', 'folder', or a description of any other kind."""

    name: str
    kind: str
    content: BinaryIO | None


def unpack(archive: str, folder: str, bounds: Bounds = OF_A_STUDENT) -> None:
    """Unpack a zip or tar archive into a new folder.

    :raises UnusableInput: when the archive is too large, or a member is not allowed. A member must be a file or folder
        inside the given folder, with a valid and unique name. The message names the member. Files that were written before
        it remain.
    """
    try:
        _refuse_size(archive, bounds)
        os.makedirs(folder)
        with open(os.open(archive, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK), 'rb') as file:
            members = _zip_members(file, bounds) if zipfile.is_zipfile(file) else _tar_members(file, bounds)
            _write_all(members, folder, bounds, os.path.getsize(archive))
    except zipfile.BadZipFile as error:
        raise refused(f'is not a complete zip file: {error}') from None
    except (tarfile.TarError, EOFError, zlib.error, ValueError, RuntimeError, NotImplementedError) as error:
        raise refused(f'cannot be unpacked: {error}') from None
    except OSError as error:
        raise refused(f'cannot be unpacked: {error.strerror or error}') from None


def refused(reason: str) -> UnusableInput:
    """Return the error for a refused archive."""
    return UnusableInput(
        f'the archive {reason}', help='pack the launch file or the package as a plain .zip or .tar.gz, without links'
    )


def _refuse_size(archive: str, bounds: Bounds) -> None:
    found = os.lstat(archive)
    if not stat.S_ISREG(found.st_mode):
        raise refused('is not a regular file')
    if found.st_size > bounds.packed:
        raise refused(f'is larger than {bounds.packed // MEBI} MiB')


def _write_all(members: Iterator[Member], folder: str, bounds: Bounds, packed: int) -> None:
    total = files = 0
    for member in members:
        parts = _parts(member.name)
        if member.kind not in ('file', 'folder'):
            raise refused(f'holds {member.kind}: {member.name!r}')
        files += 1
        if files > bounds.files:
            raise refused(f'contains more than {bounds.files} files')
        path = os.path.join(folder, *parts)
        os.makedirs(path if member.kind == 'folder' else os.path.dirname(path), exist_ok=True)
        if member.content is None:
            continue
        try:
            target = open(os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_NOFOLLOW, 0o644), 'wb')  # noqa: SIM115
        except FileExistsError:
            raise refused(f'contains two files with one name: {member.name!r}') from None
        with target:
            while data := member.content.read(CHUNK):
                total += len(data)
                if total > bounds.unpacked:
                    raise refused(f'contains more than {bounds.unpacked // MEBI} MiB')
                if total > max(RATIO_FROM, HIGHEST_RATIO * packed):
                    raise refused(f'unpacks to more than {HIGHEST_RATIO} times its size')
                target.write(data)


def _parts(name: str) -> list[str]:
    """Return the parts of a member's path, without '.' and empty parts."""
    parts = [part for part in name.split('/') if part not in ('', '.')]
    if name.startswith('/') or '..' in parts:
        raise refused(f'contains a path that leads out of it: {name!r}')
    if not name.isprintable() or '\\' in name or (parts and ':' in parts[0]):
        raise refused(f'contains an odd name: {name!r}')
    if len(os.fsencode(name)) > LONGEST_NAME or any(len(os.fsencode(part)) > LONGEST_PART for part in parts):
        raise refused(f'contains a name that is too long: {name[:60]!r}...')
    if len(parts) > DEEPEST:
        raise refused(f'contains directories deeper than {DEEPEST}: {name[:60]!r}...')
    return parts


def _zip_members(file: BinaryIO, bounds: Bounds) -> Iterator[Member]:
    _refuse_directory(file, bounds)
    with zipfile.ZipFile(file) as archive:
        for info in archive.infolist():
            kind = _zip_kind(info)
            if kind != 'file':
                yield Member(info.orig_filename, kind, None)
                continue
            with archive.open(info) as content:
                yield Member(info.orig_filename, kind, content)  # type: ignore[arg-type]  # an io.BufferedIOBase


def _refuse_directory(file: BinaryIO, bounds: Bounds) -> None:
    """Refuse a list of files that is so long that reading it would fill the memory."""
    end = file.seek(0, os.SEEK_END)
    file.seek(max(0, end - CHUNK - len(END_OF_ZIP) - 18))
    tail = file.read()
    place = tail.rfind(END_OF_ZIP)
    size = int.from_bytes(tail[place + 12 : place + 16], 'little')
    if size > bounds.files * ENTRY_BYTES:
        raise refused(f'contains more than {bounds.files} files')


def _zip_kind(info: zipfile.ZipInfo) -> str:
    mode = info.external_attr >> 16
    if info.flag_bits & 1:
        return 'a file that is encrypted'
    if stat.S_IFMT(mode) not in (0, stat.S_IFREG, stat.S_IFDIR):
        return 'a link' if stat.S_ISLNK(mode) else 'what is no file'
    return 'folder' if info.is_dir() else 'file'


def _tar_members(file: BinaryIO, bounds: Bounds) -> Iterator[Member]:
    # Count the decompressed bytes, because the sizes in headers may be false.
    with tarfile.open(fileobj=_Counted(_decompressed(file), bounds), mode='r|') as archive:
        for info in archive:
            kind = 'file' if info.isreg() and not info.issparse() else 'folder' if info.isdir() else 'what is no file'
            if info.issym() or info.islnk():
                kind = 'a link'
            yield Member(info.name, kind, archive.extractfile(info) if kind == 'file' else None)  # type: ignore[arg-type]


def _decompressed(file: BinaryIO) -> BinaryIO:
    file.seek(0)
    magic = file.read(6)
    file.seek(0)
    if magic[:2] == b'\x1f\x8b':
        return gzip.GzipFile(fileobj=file)  # type: ignore[return-value]
    if magic[:3] == b'BZh':
        return bz2.BZ2File(file)  # type: ignore[return-value]
    if magic == b'\xfd7zXZ\x00':
        raise refused('is packed with xz')
    return file


class _Counted(io.RawIOBase):
    """A stream that raises an error as soon as it has returned more bytes than the bounds allow."""

    def __init__(self, stream: BinaryIO, bounds: Bounds) -> None:
        self._stream = stream
        self._left = bounds.unpacked + bounds.files * 1024
        self._most = bounds.unpacked

    def read(self, size: int = -1) -> bytes:
        if size > self._left:
            raise refused(f'contains more than {self._most // MEBI} MiB')
        data = self._stream.read(size)
        self._left -= len(data)
        return data
