"""A source workspace presented as if it were installed: a prefix folder of symbolic links.

The folder lies in the user's temporary folder under a name made from the workspace's path, so that the paths
which programs see repeat from run to run. It goes away with the last index that uses it.
"""

from __future__ import annotations

import os
import weakref

from edulaunch.packages.reading import Contents


class Image:
    """The generated prefix of one workspace. Packages are put into it when they are first asked for.

    :param workspace: the folder with the sources; :attr:`path` is the prefix, which need not exist yet.
    """

    def __init__(self, workspace: str) -> None:
        self.path = os.path.join(_base(), f'{os.path.basename(workspace) or "root"}-{_digest(workspace)}')
        self._sources: dict[str, str] = {}
        self._claimed = False

    def add(self, package: str, contents: Contents) -> None:
        """Install a package: links to its files, and folders for its entry points.

        What an earlier reading of the package has left there goes: somebody else may have used the folder all the time.
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
        """Remove the links that the package does not install any more."""
        wanted = {os.path.join(self.path, name) for name in contents.files}
        for place in ('share', 'lib'):
            for folder, _, names in os.walk(os.path.join(self.path, place, package)):
                for path in (os.path.join(folder, name) for name in names):
                    if path not in wanted:
                        os.unlink(path)

    def add_folder(self, name: str) -> str:
        """Make a folder in the prefix; gives its path."""
        self._claim()
        path = os.path.join(self.path, name)
        os.makedirs(path, exist_ok=True)
        return path

    def source_path(self, path: str) -> str | None:
        """The real file behind a path of the image, or None when it is not from here."""
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
        """Use the folder, afresh when nobody else does; given up when this object goes, or at exit."""
        if self._claimed:
            return
        self._claimed = True
        users = os.path.join(self.path, '.users')
        if not _living(users):
            _remove(self.path)
        os.makedirs(users, exist_ok=True)
        claim = os.path.join(users, f'{os.getpid()}-{id(self):x}')
        with open(claim, 'w', encoding='ascii'):
            pass
        weakref.finalize(self, _release, self.path, claim, os.getpid())


def _release(path: str, claim: str, pid: int) -> None:
    if os.getpid() != pid:
        return  # a forked child must not take the folder from its parent
    if os.path.exists(claim):
        os.unlink(claim)
    if not _living(os.path.dirname(claim)):
        _remove(path)


def _remove(path: str) -> None:
    if os.path.isdir(path):
        import shutil

        shutil.rmtree(path, ignore_errors=True)


def _living(users: str) -> bool:
    """Whether any claim belongs to a process that still runs."""
    try:
        claims = os.listdir(users)
    except OSError:
        return False
    return any(_runs(int(claim.partition('-')[0])) for claim in claims)


def _runs(pid: int) -> bool:
    if os.name == 'nt':
        return True  # asking would send it a ctrl-c there; the folder of links is left to the system
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    except OSError:
        return True  # somebody else's process, but there
    return True


def _base() -> str:
    """A folder that belongs to this user alone, below the temporary folder."""
    import tempfile

    user = str(os.getuid()) if hasattr(os, 'getuid') else 'user'
    path = os.path.join(tempfile.gettempdir(), f'edulaunch-{user}')
    try:
        os.makedirs(path, mode=0o700, exist_ok=True)
        if not hasattr(os, 'getuid') or os.stat(path).st_uid == os.getuid():
            return path
    except OSError:
        pass  # somebody else made it, or a file of that name is in the way: take a private folder instead
    return tempfile.mkdtemp(prefix='edulaunch-')


def _digest(workspace: str) -> str:
    import hashlib

    return hashlib.sha256(os.path.realpath(workspace).encode()).hexdigest()[:8]


def _link(source: str, target: str) -> None:
    """Make `target` show `source`; a copy where the file system has no symbolic links."""
    try:
        if os.readlink(target) == source:
            return
        os.unlink(target)
    except FileNotFoundError:
        os.makedirs(os.path.dirname(target), exist_ok=True)
    except OSError:
        os.unlink(target)  # a copy from before, or a file in the way
    try:
        os.symlink(source, target)
    except FileExistsError:
        pass  # another session made it meanwhile
    except OSError:
        import shutil

        shutil.copy2(source, target)
