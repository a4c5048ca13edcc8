"""A folder of source packages, read without a build, and presented as if it were installed in a prefix folder of symbolic links.

The prefix is in the user's temporary folder. Its name is derived from the workspace's path, so that programs get the same paths
in each run. The prefix is deleted with the last index that uses it.
"""

from __future__ import annotations

import os
import weakref
from collections.abc import Iterator
from contextlib import contextmanager

from edulaunch.engine.packages.prefix import is_python
from edulaunch.engine.packages.reading import (
    Contents,
    Manifest,
    PackageWarning,
    Program,
    SourceReader,
    find_packages,
    read_manifest,
)
from edulaunch.engine.underlay_place import help_text


class Image:
    """The generated prefix of one workspace. Each package is added on its first use.

    :param workspace: the folder with the sources; :attr:`path` is the prefix, which may not exist yet.
    """

    def __init__(self, workspace: str) -> None:
        self.path = os.path.join(_base(), f'{os.path.basename(workspace) or "root"}-{_digest(workspace)}')
        self._sources: dict[str, str] = {}
        self._claimed = False

    def add(self, package: str, contents: Contents) -> None:
        """Install a package: create links to its files, and folders for its entry points.

        Links that an earlier version of the package has left in the folder are deleted.
        """
        self._claim()
        self._clear(package, contents)
        for name, source in contents.files.items():
            target = os.path.join(self.path, name)
            self._sources[target] = source
            _link(source, target)
        for name in contents.entry_points:
            self.add_folder(os.path.dirname(name))

    def _clear(self, package: str, contents: Contents) -> None:
        """Remove the links to files that the package no longer installs."""
        wanted = {os.path.join(self.path, name) for name in contents.files}
        for place in ('share', 'lib'):
            for folder, _, names in os.walk(os.path.join(self.path, place, package)):
                for path in (os.path.join(folder, name) for name in names):
                    if path not in wanted:
                        os.unlink(path)

    def add_folder(self, name: str) -> str:
        """Create a folder in the prefix, and return its path."""
        self._claim()
        path = os.path.join(self.path, name)
        os.makedirs(path, exist_ok=True)
        return path

    def source_path(self, path: str) -> str | None:
        """Return the source file or folder behind a path of the image, or None for any other path."""
        if not path.startswith(self.path + os.sep):
            return None
        source = self._sources.get(path)
        if source is not None:
            return source
        inside = sorted(target for target in self._sources if target.startswith(path + os.sep))
        if not inside:
            return None
        depth = inside[0][len(path) + 1 :].count(os.sep) + 1
        return self._sources[inside[0]].rsplit(os.sep, depth)[0]

    def _claim(self) -> None:
        """Mark the folder as used by this process, and empty it first if no other process uses it.

        The mark is removed when this object is deleted, or at exit.
        """
        if self._claimed:
            return
        self._claimed = True
        users = os.path.join(self.path, '.users')
        claim = os.path.join(users, f'{os.getpid()}-{id(self):x}')
        with _locked(os.path.dirname(self.path)):  # another process must not remove the folder in between
            if not _living(users):
                _remove(self.path)
            os.makedirs(users, exist_ok=True)
            with open(claim, 'w', encoding='ascii'):
                pass
        weakref.finalize(self, _release, self.path, claim, os.getpid())


def _release(path: str, claim: str, pid: int) -> None:
    if os.getpid() != pid:
        return  # the folder belongs to the parent process, not to a forked child
    if not os.path.exists(claim):
        return
    with _locked(os.path.dirname(path)):
        os.unlink(claim)
        if not _living(os.path.dirname(claim)):
            _remove(path)


@contextmanager
def _locked(folder: str) -> Iterator[None]:
    """Keep other processes of this user from claiming or removing a prefix in this folder."""
    try:
        import fcntl
    except ImportError:  # Windows, and Python in a browser
        yield
        return

    with open(os.path.join(folder, '.lock'), 'w', encoding='ascii') as file:
        fcntl.lockf(file, fcntl.LOCK_EX)  # closing the file releases it; flock is refused in a sandbox
        yield


def _remove(path: str) -> None:
    if os.path.isdir(path):
        import shutil

        shutil.rmtree(path, ignore_errors=True)


def _living(users: str) -> bool:
    """Return whether any process that uses the folder is still running."""
    try:
        claims = os.listdir(users)
    except OSError:
        return False
    return any(_runs(int(claim.partition('-')[0])) for claim in claims)


def _runs(pid: int) -> bool:
    if os.name == 'nt':
        return True  # os.kill would send it a Ctrl-C on Windows; the system removes the folder of links later
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    except OSError:
        return True  # the process exists, but belongs to another user
    return True


def _base() -> str:
    """Return a folder in the temporary folder that belongs only to this user."""
    import tempfile

    user = str(os.getuid()) if hasattr(os, 'getuid') else 'user'
    path = os.path.join(tempfile.gettempdir(), f'edulaunch-{user}')
    try:
        os.makedirs(path, mode=0o700, exist_ok=True)
        if not hasattr(os, 'getuid') or os.stat(path).st_uid == os.getuid():
            return path
    except OSError:
        pass  # another user created it, or a file has that name: use a private folder instead
    return tempfile.mkdtemp(prefix='edulaunch-')


def _digest(workspace: str) -> str:
    import hashlib

    return hashlib.sha256(os.path.realpath(workspace).encode()).hexdigest()[:8]


def _link(source: str, target: str) -> None:
    """Make `target` a link to `source`, or a copy of it if the file system has no symbolic links."""
    try:
        if os.readlink(target) == source:
            return
        os.unlink(target)
    except FileNotFoundError:
        os.makedirs(os.path.dirname(target), exist_ok=True)
    except OSError:
        os.unlink(target)  # an earlier copy exists, or a file has that name
    try:
        os.symlink(source, target)
    except FileExistsError:
        pass  # another session has created it in the meantime
    except OSError:
        import shutil

        shutil.copy2(source, target)


class Workspace:
    """One source workspace. It finds its packages on first use, and reads each package when the package is first used.

    :param folder: the workspace, its `src/`, or a single package.
    :param read_source: the function that reads the build file of a package.
    :param warnings: the list to which everything is added that a build would reject.
    :param near: a folder; if two packages have the same name, the package that is nearer to this folder is used.
    """

    def __init__(self, folder: str, read_source: SourceReader, warnings: list[PackageWarning], near: str = '') -> None:
        self.folder = os.path.abspath(folder)
        self._near = os.path.realpath(near) if near else ''
        self._read_source = read_source
        self._image = Image(self.folder)
        self.path = self._image.path
        self._warnings = warnings
        self._found: dict[str, Manifest] | None = None
        self._contents: dict[str, Contents] = {}
        self._installed: set[str] = set()

    def packages(self) -> list[str]:
        """Return the names in the package.xml files, sorted."""
        return sorted(self._manifests())

    def install(self, package: str) -> None:
        """Add the package to the generated prefix."""
        if package not in self._installed:
            self._image.add(package, self.contents(package))
            self._installed.add(package)

    def executables(self, package: str) -> list[str]:
        """Return the names of the entry points and of the installed programs."""
        folder = f'lib/{package}'
        contents = self.contents(package)
        return sorted(
            os.path.basename(name) for name in {*contents.entry_points, *contents.programs} if os.path.dirname(name) == folder
        )

    def program(self, package: str, executable: str) -> Program | None:
        """Return a console script, or an installed Python file. Return None for any other executable."""
        name = f'lib/{package}/{executable}'
        contents = self.contents(package)
        path = os.path.join(self.path, name)
        entry = contents.entry_points.get(name)
        roots = tuple(dict.fromkeys(os.path.dirname(place) for place in contents.python_modules.values()))
        if entry is not None:
            return Program('entry_point', package, executable, path, entry[0], entry[1], python_roots=roots)
        if name in contents.programs and is_python(contents.files[name]):
            return Program('script', package, executable, path, file=contents.files[name], python_roots=roots)
        return None

    def modules(self) -> dict[str, str]:
        """Return the modules that the packages' build files install."""
        found: dict[str, str] = {}
        for package in self.packages():
            for name, path in self.contents(package).python_modules.items():
                found.setdefault(name, path)
        return found

    def interface_packages(self) -> list[str]:
        """Return the packages whose build file generates or installs interfaces, and add the files of these packages to the
        prefix.
        """
        found = [package for package in self.packages() if self.contents(package).interfaces]
        for package in found:
            self.install(package)
        return found

    def source_path(self, path: str) -> str | None:
        """Return the student's own file for a path in the generated prefix, or None for any other path."""
        return self._image.source_path(path)

    def contents(self, package: str) -> Contents:
        """Return the files and programs that the package installs. The first call reads the build file of the package."""
        contents = self._contents.get(package)
        if contents is None:
            contents = self._contents[package] = self._read_source(self._manifests()[package])
            self._warnings += contents.warnings
        return contents

    def package_folder(self, package: str) -> str:
        """Return the folder with the package.xml of a package."""
        return self._manifests()[package].folder

    def _manifests(self) -> dict[str, Manifest]:
        if self._found is None:
            self._found = {}
            for folder in sorted(find_packages(self.folder, self._warnings), key=self._distance):
                manifest = read_manifest(folder, self._warnings)
                if manifest is not None:
                    self._note(self._found, manifest)
        return self._found

    def _distance(self, folder: str) -> int:
        """Return the number of steps upwards from `near` to the first folder that also contains the package."""
        shared = os.path.commonpath([self._near, os.path.realpath(folder)]) if self._near else ''
        return self._near.count(os.sep) - shared.rstrip(os.sep).count(os.sep)

    def _note(self, found: dict[str, Manifest], manifest: Manifest) -> None:
        first = found.setdefault(manifest.name, manifest)
        if first is not manifest:
            other = os.path.relpath(first.folder, self.folder)
            self._warnings.append(
                PackageWarning(
                    os.path.join(manifest.folder, 'package.xml'),
                    0,
                    help_text('same-package', name=manifest.name, other=other),
                    'same name',
                )
            )
