"""Where files of a package belong, so that a build installs them."""

from __future__ import annotations

import os
from fnmatch import fnmatch

from edulaunch.workspace.sources import SourcePackage

LAUNCH_PATTERN = '*launch.[pxy][yma]*'
DATA_FOLDERS = ('config', 'params', 'param', 'rviz', 'urdf', 'worlds', 'maps', 'meshes')


def install_facts(package: SourcePackage, path: str) -> dict[str, str | None]:
    """How a data file comes to be installed; None for what does not apply.

    :returns: `beside`, the folder whose files are installed already; else `move`, the folder that it belongs in when it lies
        beside the build file; `folder` and `pattern` for setup.py; `top` for CMakeLists.txt.
    """
    folder, name = os.path.split(package.relative(path))
    place = folder or ('launch' if package.is_launch_file(path) else 'config')
    ending = os.path.splitext(name)[1]
    is_beside = not folder and any(f'/{place}/' in target and target.endswith(ending) for target in package.contents.files)
    return {
        'beside': place if is_beside else None,
        'move': None if folder else place,
        'folder': place,
        'pattern': os.path.join(place, _pattern(package, path, name)) if package.is_python else None,
        'top': place.split(os.sep)[0],
    }


def _pattern(package: SourcePackage, path: str, name: str) -> str:
    """What glob() finds the file with: for launch files the pattern of ROS 2's tutorials, if it fits."""
    if not package.is_launch_file(path):
        return '*'
    return LAUNCH_PATTERN if fnmatch(name, LAUNCH_PATTERN) else '*' + os.path.splitext(name)[1]
