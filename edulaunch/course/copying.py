"""`edulaunch course copy` and `release`: a course as its students get it, in a folder or a zip file."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from hashlib import sha256
from typing import NamedTuple

from edulaunch.errors import UnusableInput

RECORD = '.edulaunch_course.json'
"""Beside the copy: what each file was when it was copied, so that a later copy knows which of them the student changed."""
MOST_NAMED = 8
_NO_DATE = (1980, 1, 1, 0, 0, 0)


class Copied(NamedTuple):
    """What a copy did: files written, and those of the student's that were left alone though the course has other ones."""

    written: list[str]
    left_alone: list[str]


def copy_files(files: Mapping[str, bytes], target: str, *, update: bool = False) -> Copied:
    """Write the files into a folder. A file that is there and differs stays, unless it is as an earlier copy left it.

    :param update: leave what the student changed, and write the others; else the whole copy is refused.
    :raises UnusableInput: when the student changed files and `update` is not set; nothing is written then. Also when a file
        cannot be read or written.
    """
    known = _record(target)
    wanted = [name for name, data in files.items() if _read(target, name) != data]
    changed = [name for name in wanted if _is_changed(target, name, known)]
    if changed and not update:
        more = f' and {len(changed) - MOST_NAMED} more' if len(changed) > MOST_NAMED else ''
        raise UnusableInput(
            f'in {target} you changed {", ".join(changed[:MOST_NAMED])}{more}: nothing was copied',
            help='--update leaves your files alone and copies what is new; or copy into another folder',
        )
    written = [name for name in wanted if name not in changed]
    for name in written:
        _write(target, name, files[name])
    digests = {name: _digest(files[name]) for name in files if name not in changed}
    _write(target, RECORD, (json.dumps({**known, **digests}, indent=1, sort_keys=True) + '\n').encode())
    return Copied(written, changed)


def write_zip(files: Mapping[str, bytes], path: str) -> None:
    """A zip file of the same bytes whenever the files are the same.

    :raises UnusableInput: when it cannot be written.
    """
    from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

    try:
        with ZipFile(path, 'w', ZIP_DEFLATED) as zipped:
            for name, data in files.items():
                entry = ZipInfo(name, _NO_DATE)
                entry.external_attr = 0o644 << 16
                zipped.writestr(entry, data, ZIP_DEFLATED)
    except OSError as error:
        raise UnusableInput(f'{path} cannot be written: {error.strerror}') from None


def _is_changed(target: str, name: str, known: Mapping[str, str]) -> bool:
    there = _read(target, name)
    return there is not None and known.get(name) != _digest(there)


def _digest(data: bytes) -> str:
    return sha256(data).hexdigest()


def _record(target: str) -> dict[str, str]:
    """What was copied before; a record that cannot be read knows nothing, so that every file that differs counts as changed."""
    try:
        found = json.loads(_read(target, RECORD) or b'{}')
    except ValueError:
        return {}
    return found if isinstance(found, dict) else {}


def _read(target: str, name: str) -> bytes | None:
    try:
        with open(os.path.join(target, *name.split('/')), 'rb') as file:
            return file.read()
    except FileNotFoundError:
        return None
    except OSError as error:
        raise UnusableInput(f'{os.path.join(target, name)} cannot be read: {error.strerror}') from None


def _write(target: str, name: str, data: bytes) -> None:
    path = os.path.join(target, *name.split('/'))
    try:
        os.makedirs(os.path.dirname(os.path.abspath(path)), exist_ok=True)
        with open(path, 'wb') as file:
            file.write(data)
    except OSError as error:
        raise UnusableInput(f'{path} cannot be written: {error.strerror}') from None
