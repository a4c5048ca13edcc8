"""Finds launch files as `ros2 launch` does."""

from __future__ import annotations

import os

from edulaunch.engine.nearest import nearest_file
from edulaunch.engine.packages import Index
from edulaunch.engine.processes.current import current_process
from edulaunch.errors import UnusableInput
from edulaunch.ros.sources.missing import missing_launch_file, missing_package
from edulaunch.runtime.fittings import help_of_facts

SURE_LAUNCH_SUFFIXES = ('.launch.py', '.launch.xml', '.launch.yaml', '_launch.py', '_launch.xml', '_launch.yaml', '.launch')
LAUNCH_SUFFIXES = ('.py', '.xml', '.yaml', '.yml', '.launch')


def find_launch_file(index: Index, path_or_package: str | os.PathLike[str], file: str | None, *, as_ros: bool = False) -> str:
    """Return the absolute path of a launch file, which is given as for `ros2 launch`.

    :param as_ros: whether a package without the name of a launch file gets the message of `ros2 launch`.
    :raises UnusableInput: when there is no such file, with the message of `ros2 launch` and the nearest name.
    """
    first = os.fspath(path_or_package)
    if file is None and (os.path.exists(first) or os.sep in first or first.endswith(LAUNCH_SUFFIXES)):
        return _existing_file(first, index)
    from ros2launch.api import MultipleLaunchFilesError, get_share_file_path_from_package

    process = current_process()
    outer, process.index = process.index, index
    try:
        path = str(get_share_file_path_from_package(package_name=first, file_name=file))
        return path if os.path.isfile(path) else _existing_file(os.path.realpath(path), index)
    except MultipleLaunchFilesError as error:
        raise UnusableInput(str(error), help='type the path of the launch file') from None
    except (FileNotFoundError, LookupError, ValueError, RuntimeError) as error:
        text = str(error.args[0]) if error.args else str(error)
        if file is None and isinstance(error, FileNotFoundError) and not as_ros:
            text = f'the launch file of the package {first} is not named'
        raise UnusableInput(text, help=_nearest_help(index, first, file)) from None
    finally:
        process.index = outer


def _existing_file(path: str, index: Index) -> str:
    absolute = os.path.abspath(path)
    if os.path.isdir(absolute):
        inside = sorted(name for name in os.listdir(absolute) if name.endswith(LAUNCH_SUFFIXES))
        raise UnusableInput(
            f'{path!r} is a folder, not a launch file.',
            help=f'name a file in it: {", ".join(inside[:5])}' if inside else 'give the path of a launch file',
        )
    if not os.path.isfile(absolute):
        folder = os.path.dirname(absolute)
        names = sorted(name for name in os.listdir(folder) if name.endswith(LAUNCH_SUFFIXES)) if os.path.isdir(folder) else []
        near = nearest_file(os.path.basename(absolute), names)
        help = f'check the path: the folder {folder!r} does not exist'
        if near:
            help = f'did you mean {os.path.join(os.path.dirname(path), near)!r}?'
        elif owner := _package_with(index, os.path.basename(absolute)):
            help = f'name its package, too: ros2 launch {owner} {os.path.basename(absolute)}'
        elif os.path.isdir(folder):
            help = 'check the spelling and the folder you are in; in a notebook, run the cell that writes the file first'
        raise UnusableInput(f'launch file {path!r} does not exist.', help=help)
    return absolute


def _package_with(index: Index, name: str) -> str | None:
    """Return the only package of the workspaces that installs a launch file of that name. Otherwise, return None."""
    own = [package for package in index.packages() if index.source_folder(package) is not None]
    owners = [one for one in own if os.path.isfile(os.path.join(index.share(one) or '', 'launch', name))]
    return owners[0] if len(owners) == 1 else None


def _nearest_help(index: Index, package: str, file: str | None) -> str:
    if package not in index.packages():
        path = os.path.join(package, file or '')
        if file and os.path.isfile(path):
            return f'write the path as one word: {path}'
        return help_of_facts(missing_package(index, package))
    names = launch_files_of(index, package)
    if file is None and names:
        return f'name a launch file of {package}: {", ".join(names)}'
    not_installed = missing_launch_file(index, package, file)
    if not_installed:
        return help_of_facts(not_installed)
    near = None if file is None else nearest_file(file, names)
    listed = (
        f'choose a launch file of {package}: {", ".join(names)}' if names else f'add a launch file to {package}, which has none'
    )
    return f'did you mean {near!r}?' if near else listed


def launch_argument(word: str) -> tuple[str, str]:
    """Return the name and the value of `name:=value`.

    :raises UnusableInput: for a word of another form, with ROS 2's message.
    """
    name, sign, value = word.partition(':=')
    if not (name and sign and value):
        hint = f'write {word.replace("=", ":=", 1)}' if '=' in word and not sign else f'write {name or "name"}:=VALUE'
        raise UnusableInput(f"malformed launch argument '{word}', expected format '<name>:=<value>'", help=hint)
    return name, value


def launch_files_of(index: Index, package: str) -> list[str]:
    """Return the names of the launch files in a package's share folder, in alphabetical order.

    Files whose names end in plain .py, .xml or .yaml count only in a folder named launch.
    """
    return sorted(
        {
            name
            for folder, _, names in os.walk(index.share(package) or '')
            for name in names
            if name.endswith(SURE_LAUNCH_SUFFIXES) or (os.path.basename(folder) == 'launch' and name.endswith(LAUNCH_SUFFIXES))
        }
    )
