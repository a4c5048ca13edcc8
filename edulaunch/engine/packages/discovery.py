"""Finds the workspaces for a command that does not name one. A user of a real ROS 2 would have sourced them."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping, Sequence

from edulaunch.engine.underlay_place import underlay_prefix

INSTALL_SIGNS = ('.colcon_install_layout', 'local_setup.bash', 'local_setup.sh', os.path.join('share', 'ament_index'))
"""Files in a folder into which colcon has installed packages."""
_DISTRIBUTION_SIGNS = (os.path.join('share', 'rclpy'), os.path.join('share', 'ros_environment'))
"""Files in the prefix of ROS 2 itself, which is never a workspace."""


def install_folders(folders: Iterable[str | os.PathLike[str]]) -> tuple[list[str], list[str]]:
    """Separate folders that colcon built (`install/`) from folders with source packages; return absolute paths, in the given
    order.

    A workspace with both is read from source, because the student means the current source files, built or not.
    """
    paths = [os.path.abspath(os.fspath(folder)) for folder in folders]
    built = [path for path in paths if any(os.path.exists(os.path.join(path, sign)) for sign in INSTALL_SIGNS)]
    return built, [path for path in paths if path not in built]


def find_workspaces(folder: str, env: Mapping[str, str], launch_file: str | None = None) -> list[str]:
    """Return the absolute paths of the workspaces for a command in order of search, each of them once.

    The search covers EDULAUNCH_WORKSPACES, the parents of the launch file, and the parents of the current folder. If no parent
    has a workspace, it covers one level below the current folder. AMENT_PREFIX_PATH and COLCON_PREFIX_PATH come last, as a real
    `install/setup.bash` sets them.

    :param folder: the current folder of the command.
    :param env: its environment.
    :param launch_file: path of the launch file that it names, if it names one.
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
    """Return the workspaces that `--workspace` names or, without the option, the ones for a command that launches `target`
    here.
    """
    if given:
        return [os.fspath(path) for path in given]
    return find_workspaces(os.getcwd(), os.environ, os.fspath(target) if os.path.isfile(target) else None)


def folder_of(target: str | os.PathLike[str]) -> str:
    """Return the folder of the launch file that a command names by its path, or the current folder for a package."""
    return os.path.dirname(os.path.abspath(target)) if os.path.isfile(target) else os.getcwd()


def workspace_around(path: str) -> str | None:
    """Return the workspace of a file or folder, which has the package in `src`. Without `src`, it is the folder above the package
    if that has further packages, otherwise the package. Return None outside any package.
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
    """Return the innermost folder with a `package.xml` among a path and its parents."""
    return next((folder for folder in _upwards(os.path.abspath(path)) if _has_manifest(folder)), None)


def _above(folder: str) -> list[str]:
    """Return the innermost workspace around a folder, as a list that may be empty."""
    around = workspace_around(folder)
    if around is not None:
        return [around]
    return next(([_root_of(path)] for path in _upwards(folder) if _holds_sources(path)), [])


def _around(here: str, launch_file: str | None) -> list[str]:
    """Return the current folder if the launch file is in a package below it, because `colcon build` finds all packages
    there.
    """
    path = os.path.join(here, launch_file or '')
    is_inside = path.startswith(here + os.sep) and here != os.path.expanduser('~')
    return [here] if launch_file is not None and is_inside and workspace_around(path) is not None else []


def _below(folder: str) -> list[str]:
    """Return the folder itself if it contains packages, otherwise the workspaces in it."""
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
    """Return the workspace with the sources `outer`/src. If `outer` is a home folder or the whole disk, return only the folder
    `src`.
    """
    return os.path.join(outer or os.sep, 'src') if outer in ('', os.sep, os.path.expanduser('~')) else outer


def _holds_sources(folder: str) -> bool:
    """Return whether `src` contains packages, also one level further down, where repositories are cloned."""
    sources = os.path.join(folder, 'src')
    return bool(_with_manifest(sources)) or any(_with_manifest(os.path.join(sources, name)) for name in _names(sources))


def _with_manifest(folder: str) -> list[str]:
    return [name for name in _names(folder) if _has_manifest(os.path.join(folder, name))]


def _has_manifest(folder: str) -> bool:
    return os.path.isfile(os.path.join(folder, 'package.xml'))


def _names(folder: str) -> list[str]:
    """Return the contents of a folder without hidden entries; nothing if it cannot be read."""
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
    """Return the workspace that was built into a prefix, if its sources exist; otherwise the `install` folder, or the
    prefix.
    """
    path = os.path.abspath(prefix)
    install = os.path.dirname(path) if install_folders([os.path.dirname(path)])[0] else path
    workspace = os.path.dirname(install)
    return workspace if _holds_sources(workspace) or _with_manifest(workspace) else install
