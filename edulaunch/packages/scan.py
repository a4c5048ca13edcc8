"""Finding the packages of a source workspace, as colcon does."""

from __future__ import annotations

import os

from edulaunch.packages.reading import PackageWarning

_BUILD_FOLDERS = frozenset(('build', 'install', 'log', '__pycache__', 'node_modules'))
_IGNORE_FILES = frozenset(('COLCON_IGNORE', 'AMENT_IGNORE', 'CATKIN_IGNORE', 'pyvenv.cfg'))
_MAX_FOLDERS = 5000


def find_packages(workspace: str, warnings: list[PackageWarning]) -> list[str]:
    """Folders below (or equal to) `workspace` that hold a package.xml: shallow ones first, then by the alphabet.

    Does not look inside packages, build/ install/ log/, hidden folders, virtual environments, and folders
    with a COLCON_IGNORE. Links to folders are followed, as colcon does, but no folder is taken twice; gives up
    with a warning after 5000 folders, for somebody may have named a whole home folder.
    """
    found: list[str] = []
    waiting = [workspace]
    seen: set[str] = set()
    while waiting:
        folder = waiting.pop()
        real = os.path.realpath(folder)
        if real in seen:
            continue
        seen.add(real)
        if len(seen) > _MAX_FOLDERS:
            warnings.append(
                PackageWarning(
                    workspace,
                    0,
                    f'more than {_MAX_FOLDERS} folders; the rest was not searched for packages. Name the workspace folder itself',
                )
            )
            break
        files, folders = _list(folder)
        if files & _IGNORE_FILES:
            continue
        if 'package.xml' in files:
            found.append(folder)
        else:
            waiting += [os.path.join(folder, name) for name in reversed(folders)]
    return sorted(found, key=lambda folder: (folder.count(os.sep), folder))


def _list(folder: str) -> tuple[frozenset[str], list[str]]:
    """Names of the files, and of the folders worth entering: real ones before links, so that a folder that can be
    reached both ways is found where it lies."""
    files: list[str] = []
    folders: list[str] = []
    links: list[str] = []
    try:
        with os.scandir(folder) as entries:
            for entry in entries:
                if not entry.is_dir():
                    files.append(entry.name)
                elif not entry.name.startswith('.') and entry.name not in _BUILD_FOLDERS:
                    (links if entry.is_symlink() else folders).append(entry.name)
    except OSError:
        return frozenset(), []  # a folder we may not read holds no package that we could use
    return frozenset(files), [*sorted(folders), *sorted(links)]
