"""Finds the workspaces for a command that does not name one. In ROS 2, the user would have sourced these workspaces."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping, Sequence

from edulaunch.engine.packages.reading import IGNORE_FILES, list_folder
from edulaunch.engine.underlay_place import underlay_prefix

INSTALL_SIGNS = ('.colcon_install_layout', 'local_setup.bash', 'local_setup.sh', os.path.join('share', 'ament_index'))
"""Files in a folder into which colcon has installed packages."""
_DISTRIBUTION_SIGNS = (os.path.join('share', 'rclpy'), os.path.join('share', 'ros_environment'))
"""Files in the prefix of ROS 2 itself, which is never a workspace."""
_MOST_FOLDERS = 1000
"""After that many folders, a search for the first package below a folder does not go deeper."""


def install_folders(folders: Iterable[str | os.PathLike[str]]) -> tuple[list[str], list[str]]:
    """Return the `install/` folders that colcon built, and the other folders. All paths are absolute, in the given order.

    A workspace folder with sources is one of the other folders, even if colcon built it, because the student means the
    current source files.
    """
    paths = [os.path.abspath(os.fspath(folder)) for folder in folders]
    built = [path for path in paths if any(os.path.exists(os.path.join(path, sign)) for sign in INSTALL_SIGNS)]
    return built, [path for path in paths if path not in built]


def find_workspaces(folder: str, env: Mapping[str, str], launch_file: str | None = None) -> list[str]:
    """Return the absolute paths of the workspaces for a command, without duplicates, in order of search.

    The search covers EDULAUNCH_WORKSPACES, the parents of the launch file, and the parents of the current folder. If no
    parent has a workspace, the search covers one level below the current folder. AMENT_PREFIX_PATH and COLCON_PREFIX_PATH
    come last, as a real `install/setup.bash` sets them.

    :param folder: the current folder of the command.
    :param env: the environment of the command.
    :param launch_file: the path of the launch file that the command names, or None.
    """
    here = os.path.abspath(folder)
    found = [os.path.join(here, path) for path in _listed(env, 'EDULAUNCH_WORKSPACES') if os.path.isdir(os.path.join(here, path))]
    if launch_file is not None:
        found += _above(os.path.dirname(os.path.join(here, launch_file)))
    found += _above(here) or _below(here) or _around(here, launch_file)
    found += map(_of_prefix, filter(_is_overlay, [*_listed(env, 'COLCON_PREFIX_PATH'), *_listed(env, 'AMENT_PREFIX_PATH')]))
    first = {os.path.realpath(path): os.path.normpath(path) for path in reversed(found)}
    return [first[real] for real in dict.fromkeys(map(os.path.realpath, found))]


def workspaces_of_command(given: Sequence[str | os.PathLike[str]], target: str | os.PathLike[str]) -> list[str]:
    """Return the workspaces that `--workspace` names. Without this option, find the workspaces for a command in the current
    folder.

    :param given: the values of `--workspace`.
    :param target: the launch file or the package that the command names.
    """
    if given:
        return [os.fspath(path) for path in given]
    return find_workspaces(os.getcwd(), os.environ, os.fspath(target) if os.path.isfile(target) else None)


def folder_of(target: str | os.PathLike[str]) -> str:
    """Return the folder of a launch file. If `target` is not a file, return the current folder."""
    return os.path.dirname(os.path.abspath(target)) if os.path.isfile(target) else os.getcwd()


def workspace_around(path: str) -> str | None:
    """Return the workspace of a file or folder, or None outside any package.

    The workspace is the folder with the `src` folder that contains the package. Without `src`, it is the folder above the package
    if that folder has further packages. Otherwise, it is the package itself.
    """
    package = package_around(path)
    if package is None or package.startswith(underlay_prefix()):
        return None
    prefix, place = os.path.split(os.path.dirname(package))
    if place == 'share' and install_folders([prefix])[0]:
        return _of_prefix(prefix) if _is_overlay(prefix) else None
    outer, sign, _ = f'{os.path.dirname(package)}{os.sep}'.rpartition(f'{os.sep}src{os.sep}')
    if sign:
        return _root_of(outer)
    above = os.path.dirname(package)
    return above if len(_with_manifest(above)) > 1 else package


def package_around(path: str) -> str | None:
    """Return the innermost folder with a `package.xml` among a path and its parents, or None if there is no such folder."""
    return next((folder for folder in _upwards(os.path.abspath(path)) if _has_manifest(folder)), None)


def _above(folder: str) -> list[str]:
    """Return a list with the innermost workspace around a folder, or an empty list."""
    around = workspace_around(folder)
    if around is not None:
        return [around]
    return next(([_root_of(path)] for path in _upwards(folder) if _holds_sources(path)), [])


def _around(here: str, launch_file: str | None) -> list[str]:
    """Return a list with the current folder if the launch file is in a package below it, otherwise an empty list.

    The current folder is then a workspace, because `colcon build` would find all packages there.
    """
    path = os.path.join(here, launch_file or '')
    is_inside = path.startswith(here + os.sep) and here != os.path.expanduser('~')
    return [here] if launch_file is not None and is_inside and workspace_around(path) is not None else []


def _below(folder: str) -> list[str]:
    """Return a list with the folder itself if it contains packages, otherwise the workspaces that are directly in it."""
    if _with_manifest(folder):
        return [folder]
    return [path for name in _names(folder) if _holds_sources(path := os.path.join(folder, name))]


def _upwards(folder: str) -> Iterator[str]:
    while True:
        yield folder
        above = os.path.dirname(folder)
        if above == folder:
            return
        folder = above


def _root_of(outer: str) -> str:
    """Return the workspace `outer`, whose sources are in `outer`/src.

    If `outer` is a home folder or the root of the file system, return only its folder `src`.
    """
    return os.path.join(outer or os.sep, 'src') if outer in ('', os.sep, os.path.expanduser('~')) else outer


def _holds_sources(folder: str) -> bool:
    """Return whether the folder `src` contains packages, also below the repositories that are cloned there.

    The search is limited to the nearest folders, because any folder of the computer can be the current one.
    """
    waiting = [os.path.join(folder, 'src')]
    for place in waiting:
        files, folders = list_folder(place)
        if 'package.xml' in files:
            return True
        if len(waiting) < _MOST_FOLDERS and not files & IGNORE_FILES:
            waiting += [os.path.join(place, name) for name in folders]
    return False


def _with_manifest(folder: str) -> list[str]:
    return [name for name in _names(folder) if _has_manifest(os.path.join(folder, name))]


def _has_manifest(folder: str) -> bool:
    return os.path.isfile(os.path.join(folder, 'package.xml'))


def _names(folder: str) -> list[str]:
    """Return the names in a folder, sorted and without hidden ones. Return an empty list if the folder cannot be read."""
    try:
        return sorted(name for name in os.listdir(folder) if not name.startswith('.'))
    except OSError:
        return []


def _listed(env: Mapping[str, str], name: str) -> list[str]:
    return [path for path in env.get(name, '').split(os.pathsep) if path]


def _is_overlay(prefix: str) -> bool:
    is_ros = prefix == underlay_prefix() or any(os.path.isdir(os.path.join(prefix, sign)) for sign in _DISTRIBUTION_SIGNS)
    return os.path.isdir(prefix) and not is_ros


def _of_prefix(prefix: str) -> str:
    """Return the workspace from which a prefix was built, if its sources exist.

    Otherwise, return the `install` folder that contains the prefix, or the prefix itself.
    """
    path = os.path.abspath(prefix)
    install = os.path.dirname(path) if install_folders([os.path.dirname(path)])[0] else path
    workspace = os.path.dirname(install)
    return workspace if _holds_sources(workspace) or _with_manifest(workspace) else install
