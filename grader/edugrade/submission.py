"""Reads a submission, which is a launch file or a whole ROS 2 package, as bytes. This module does not run the submission."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from contextlib import suppress
from functools import cached_property
from random import Random
from typing import Any, NamedTuple

from edulaunch.errors import UnusableInput

from .faults import raise_fault
from .files import read_regular
from .source import SubmittedText

ENDINGS = tuple(mark + kind for mark in ('.launch', '_launch') for kind in ('.py', '.xml', '.yaml', '.yml'))
LARGEST_BYTES = 1_000_000


class Submission:
    """The launch file of a student, alone or in a ROS 2 package.

    :param path: the path of the launch file, or of the folder of a package with the file ``launch/<package>.launch.py``.
    :param root: the folder of the submission, if it contains several packages, or ''.
    :raises UnusableInput: if there is no such launch file; the message names the files that exist instead.
    :ivar given: the path that the user gave.
    :ivar launch_path: the path of the launch file, in the form of `given`.
    :ivar file: the absolute path of the launch file.
    :ivar folder: the absolute path of the package's folder or, without a package, of the launch file's folder.
    :ivar exercise: the name of the exercise, from the name of the launch file.
    """

    def __init__(self, path: str, root: str = '') -> None:
        self.given = path
        self._root = root
        self.launch_path = _launch_path(path)
        self.file = os.path.abspath(self.launch_path)
        self.name = os.path.basename(self.file)
        self.package: PackageFolder | None = package_above(self.file)
        self.folder = self.package.path if self.package else os.path.dirname(self.file)
        _refuse_links(path, self.file, self.folder)
        self.data = _read(self.launch_path)
        self.exercise = exercise_of(self.name)

    @property
    def workspaces(self) -> list[str]:
        """The folders in which a run searches for the student's packages, and which it may read.

        These are folders of the submission, and never folders above it.
        """
        return [os.path.abspath(self._root) if self._root else self.package.path] if self.package else []

    @property
    def named(self) -> dict[str, Any]:
        """The fields of a `Report` that describe the submission."""
        package = self.package.name if self.package else None
        return {'file': self.file, 'given': self.given, 'folder': self.folder, 'shown': self.shown_folder, 'package': package}

    @property
    def shown_folder(self) -> str:
        """`folder` as a prefix for reports, in the form of the given path. It is '' or ends with a separator."""
        inside = os.path.relpath(self.file, self.folder)
        if self.launch_path.endswith(inside):
            return self.launch_path[: -len(inside)]
        return os.path.join(os.path.relpath(self.folder), '')

    @cached_property
    def source(self) -> SubmittedText:
        """The lines of the submission, including those of all files of a package."""
        others = {os.path.join(self.folder, name): data.decode('utf-8', 'replace') for name, data in self._texts}
        return SubmittedText(self.file, self.data.decode('utf-8', 'replace'), others)

    @cached_property
    def _texts(self) -> list[tuple[str, bytes]]:
        return list(self.package.texts()) if self.package else []

    @cached_property
    def _content(self) -> bytes:
        """The content of all files that an edit can change."""
        parts = [part for name, data in self._texts for part in (os.fsencode(name), data)]
        return self.data if not parts else b'\0'.join([self.data, *parts])

    @property
    def seed(self) -> int:
        """A number that changes with every edit, because it depends on the content. The choices of the rubric depend on this
        number.
        """
        return Random(self._content).getrandbits(32)

    @property
    def sha256(self) -> str:
        """The SHA-256 digest of the content, which identifies the graded version in the report."""
        from hashlib import sha256

        return sha256(self._content).hexdigest()

    def is_as_it_was(self) -> bool:
        """Return whether all files can still be read and have not changed."""
        try:
            return Submission(self.file, self._root).sha256 == self.sha256
        except UnusableInput:
            return False


def exercise_of(name: str) -> str:
    """Return the exercise that a file name belongs to: ``circle`` for ``circle.launch.py`` and ``circle_launch.xml``."""
    for ending in ENDINGS:
        if name.endswith(ending):
            return name[: -len(ending)]
    return os.path.splitext(name)[0]


def _refuse_links(given: str, file: str, folder: str) -> None:
    """Raise an error for a link, which could lead to another student's work or to the solution.

    :raises UnusableInput: with the path of the link.
    """
    inside = os.path.relpath(file, folder)
    for path, target in ((given.rstrip(os.sep), ''), (file, os.path.join(os.path.realpath(folder), inside))):
        if os.path.exists(path) and (os.path.islink(path) if not target else os.path.realpath(path) != target):
            raise UnusableInput(f'{path} is a link, and links are not followed', help='hand in the file itself')


def _launch_path(path: str) -> str:
    """Return the launch file that a path names. For a package, this is the launch file with the package's name."""
    if not os.path.isdir(path):
        return path
    package = package_at(path)
    if package is None:
        raise UnusableInput(f'{path} is a folder; edugrade grades launch files and packages', help=_files_in(path))
    if not os.path.isfile(package.launch_file):
        raise UnusableInput(
            f'the package {package.name} has no file launch/{package.name}.launch.py',
            help=_files_in(os.path.join(path, 'launch')),
        )
    return os.path.join(path, os.path.relpath(package.launch_file, package.path))


def _read(path: str) -> bytes:
    try:
        data = read_regular(path, LARGEST_BYTES + 1)
    except FileNotFoundError:
        raise UnusableInput(f'{path} does not exist', help=_nearest_to(path)) from None
    except (OSError, ValueError) as error:  # ValueError: a zero byte in the path
        raise_fault(error)
        raise UnusableInput(f'{path} cannot be read: {getattr(error, "strerror", None) or error}') from None
    if len(data) > LARGEST_BYTES:
        raise UnusableInput(
            f'{path} is larger than {LARGEST_BYTES:,} bytes, which is too large for a launch file',
            help='type the path of the launch file',
        )
    return data


def _gradable(folder: str) -> list[str]:
    """Return the names of the launch files and packages in a folder."""
    try:
        return sorted(
            name for name in os.listdir(folder or '.') if name.endswith(ENDINGS) or package_at(os.path.join(folder, name))
        )
    except OSError:
        return []


def _files_in(folder: str) -> str:
    names = _gradable(folder)
    if not names:
        return f'there is no launch file in it (a name that ends in {ENDINGS[0]}); give the path of one'
    return 'try one of: ' + ', '.join(os.path.join(folder, name) for name in names)


def _nearest_to(path: str) -> str:
    from edulaunch.engine.nearest import nearest

    folder, name = os.path.split(path)
    if os.path.islink(path):
        return f'it is a link to {os.readlink(path)}, and that does not exist'
    if folder and not os.path.isdir(folder):
        return f'the folder {folder} does not exist either; check the current directory with pwd and ls'
    names = _gradable(folder)
    close = nearest(name, names)
    if close is not None:
        return f'did you mean {os.path.join(folder, close)}?'
    shown = f'the folder {folder}' if folder else 'the current folder'
    if not names:
        return f'type the path of a launch file ({shown} has none), or a command that `edugrade --help` lists'
    return f'type the path of a launch file or package in {shown}: {", ".join(names)}'


MANIFEST = 'package.xml'
DEEPEST = 5  # levels of folders between a launch file and its package.xml
_NAME = re.compile(r'<name>\s*([A-Za-z][\w-]*)\s*</name>')
_TEXTS = ('.py', '.xml', '.yaml', '.yml', '.cfg', '.toml', '.txt', '.msg', '.srv', '.action', '.rviz', '.urdf')
_GENERATED = ('build', 'install', 'log', '__pycache__')
LARGEST_TEXT = 1_000_000
MOST_FILES = 400
MOST_FOLDERS = 4000
DEEPEST_TEXT = 30  # levels of folders below the package's folder


class PackageFolder(NamedTuple):
    """The absolute path of a package's folder, and the name of the package."""

    path: str
    name: str

    @property
    def workspace(self) -> str:
        """The directory in which to search for packages: the colcon workspace around its ``src``, or the package itself."""
        parent = os.path.dirname(self.path)
        while os.path.dirname(parent) != parent:
            if os.path.basename(parent) == 'src':
                return os.path.dirname(parent)
            parent = os.path.dirname(parent)
        return self.path

    @property
    def launch_file(self) -> str:
        """The main launch file, which has the name of the package and is in the folder ``launch`` of the package."""
        return os.path.join(self.path, 'launch', f'{self.name}.launch.py')

    def texts(self) -> Iterator[tuple[str, bytes]]:
        """Yield (path relative to the package, content) of the first MOST_FILES text files of the package, in a fixed order.

        Links, pipes, unreadable files and files below more than DEEPEST_TEXT directories are left out.
        """
        found = 0
        for path in self._files():
            if found == MOST_FILES:
                return
            try:
                data = read_regular(path, LARGEST_TEXT)
            except OSError as error:
                raise_fault(error)
                continue
            yield os.path.relpath(path, self.path), data
            found += 1

    def _files(self) -> Iterator[str]:
        pending = [(self.path, 0)]
        for _ in range(MOST_FOLDERS):
            if not pending:
                return
            folder, depth = pending.pop()
            with suppress(OSError), os.scandir(folder) as entries:
                found = sorted((entry for entry in entries if not entry.is_symlink()), key=lambda entry: entry.name)
                yield from (entry.path for entry in found if entry.name.endswith(_TEXTS) and not entry.is_dir())
                inside = [entry for entry in found if entry.is_dir() and depth < DEEPEST_TEXT and not _is_generated(entry.name)]
                pending += [(entry.path, depth + 1) for entry in reversed(inside)]


def package_at(folder: str) -> PackageFolder | None:
    """Return the package whose package.xml is in this folder, or None if the folder is not a package."""
    try:
        match = _NAME.search(read_regular(os.path.join(folder, MANIFEST), LARGEST_TEXT).decode('utf-8', 'replace'))
    except OSError as error:
        raise_fault(error)
        return None
    path = os.path.abspath(folder)
    return PackageFolder(path, match[1] if match else os.path.basename(path))


def _is_generated(name: str) -> bool:
    return name in _GENERATED or name.startswith('.')


def package_above(file: str) -> PackageFolder | None:
    """Return the package that contains a file, or None if the file is not in a package."""
    folder = os.path.dirname(os.path.abspath(file))
    for _ in range(DEEPEST):
        package = package_at(folder)
        if package is not None or os.path.dirname(folder) == folder:
            return package
        folder = os.path.dirname(folder)
    return None
