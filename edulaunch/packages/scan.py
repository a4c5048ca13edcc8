"""Finding the packages of a source workspace, as colcon does."""

from __future__ import annotations

import os

from edulaunch.packages.reading import PackageWarning

_BUILD_FOLDERS = frozenset(('build', 'install', 'log', '__pycache__', 'node_modules'))
_IGNORE_FILES = frozenset(('COLCON_IGNORE', 'AMENT_IGNORE', 'CATKIN_IGNORE', 'pyvenv.cfg'))
_MAX_FOLDERS = 5000


def find_packages(workspace: str, warnings: list[PackageWarning]) -> list[str]:
    """Folders below (or equal to) `workspace` that hold a package.xml, in alphabetical order.

    Does not look inside packages, build/ install/ log/, hidden folders, virtual environments, and folders
    with a COLCON_IGNORE; gives up with a warning after 5000 folders, for somebody may have named a whole home
    folder.
    """
    found: list[str] = []
    waiting = [workspace]
    seen = 0
    while waiting:
        folder = waiting.pop()
        seen += 1
        if seen > _MAX_FOLDERS:
            warnings.append(
                PackageWarning(
                    workspace,
                    0,
                    f'more than {_MAX_FOLDERS} folders; the rest was not searched for packages. '
                    'Name the workspace folder itself',
                )
            )
            break
        files, folders = _list(folder)
        if files & _IGNORE_FILES:
            continue
        if 'package.xml' in files:
            found.append(folder)
        else:
            waiting += [os.path.join(folder, name) for name in sorted(folders, reverse=True)]
    return sorted(found)


def _list(folder: str) -> tuple[frozenset[str], list[str]]:
    """Names of the files, and of the folders worth entering."""
    files, folders = [], []
    try:
        with os.scandir(folder) as entries:
            for entry in entries:
                if not entry.is_dir():
                    files.append(entry.name)
                elif (
                    not entry.name.startswith('.')
                    and entry.name not in _BUILD_FOLDERS
                    and not entry.is_symlink()
                ):
                    folders.append(entry.name)
    except OSError:
        return frozenset(), []  # a folder we may not read holds no package that we could use
    return frozenset(files), folders
