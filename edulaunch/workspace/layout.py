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


def install_help(package: SourcePackage, path: str) -> str:
    """The same in words, for an error."""
    facts = install_facts(package, path)
    if facts['beside']:
        return f'move it into the folder {facts["beside"]}, as the files that are installed'
    move = f'move it into the folder {facts["move"]}, and ' if facts['move'] else ''
    if facts['pattern']:
        pair = f"(os.path.join('share', package_name, {facts['folder']!r}), glob({facts['pattern']!r}))"
        return f'{move}add {pair} to data_files of setup.py'
    return f'{move}add install(DIRECTORY {facts["top"]} DESTINATION share/${{PROJECT_NAME}}) to CMakeLists.txt'


def _pattern(package: SourcePackage, path: str, name: str) -> str:
    """What glob() finds the file with: for launch files the pattern of ROS 2's tutorials, if it fits."""
    if not package.is_launch_file(path):
        return '*'
    return LAUNCH_PATTERN if fnmatch(name, LAUNCH_PATTERN) else '*' + os.path.splitext(name)[1]
