"""Mistakes of files and folders: launch files that no build installs, files that are no Python, build output in the sources."""

from __future__ import annotations

import os
from collections.abc import Iterator
from fnmatch import fnmatch

from edulaunch.workspace.finding import Mistake
from edulaunch.workspace.sources import SourcePackage

LAUNCH_PATTERN = '*launch.[pxy][yma]*'
DATA_FOLDERS = ('config', 'params', 'param', 'rviz', 'urdf', 'worlds', 'maps', 'meshes')
BUILD_SIGNS = {
    'install': ('local_setup.bash', 'setup.bash', '.colcon_install_layout'),
    'build': ('COLCON_IGNORE', '.built_by'),
    'log': ('COLCON_IGNORE', 'latest_build'),
}


def of_package(package: SourcePackage) -> Iterator[Mistake]:
    """Mistakes of one package."""
    if package.contents.broken is None:
        yield from _not_installed(package)
    for path in package.python_files:
        yield from _no_python(path)


def _not_installed(package: SourcePackage) -> Iterator[Mistake]:
    """Launch files and data that stand in the source and that no build would install."""
    installed = {os.path.realpath(path) for path in package.contents.files.values()}
    for path in package.files():
        if os.path.realpath(path) in installed:
            continue
        top = package.relative(path).split(os.sep)[0]
        if package.is_launch_file(path):
            yield Mistake(
                path,
                0,
                f'this launch file is not installed, so `ros2 launch {package.name} {os.path.basename(path)}` does not find it',
                install_help(package, path),
            )
        elif top in DATA_FOLDERS and not os.path.basename(path).startswith('.'):
            yield Mistake(
                path,
                0,
                f'this file is not installed, so it is not in the share folder of {package.name}',
                install_help(package, path),
            )


def install_help(package: SourcePackage, path: str) -> str:
    """What to do so that a data file is installed: a line for the build file; a file that lies beside that is moved first."""
    folder, name = os.path.split(package.relative(path))
    place = folder or ('launch' if package.is_launch_file(path) else 'config')
    move = '' if folder else f'move it into the folder {place}, and '
    ending = os.path.splitext(name)[1]
    if not folder and any(f'/{place}/' in target and target.endswith(ending) for target in package.contents.files):
        return f'move it into the folder {place}, as the files that are installed'
    if package.is_python:
        pattern = os.path.join(place, _pattern(package, path, name))
        return f"{move}add (os.path.join('share', package_name, {place!r}), glob({pattern!r})) to data_files of setup.py"
    return f'{move}add install(DIRECTORY {place.split(os.sep)[0]} DESTINATION share/${{PROJECT_NAME}}) to CMakeLists.txt'


def _pattern(package: SourcePackage, path: str, name: str) -> str:
    """What glob() finds the file with: for launch files the pattern of ROS 2's tutorials, if it fits."""
    if not package.is_launch_file(path):
        return '*'
    return LAUNCH_PATTERN if fnmatch(name, LAUNCH_PATTERN) else '*' + os.path.splitext(name)[1]


def _no_python(path: str) -> Iterator[Mistake]:
    """Text that Python cannot read: wrong syntax, mixed tabs and spaces, another encoding than UTF-8."""
    try:
        with open(path, 'rb') as file:
            compile(file.read(), path, 'exec', dont_inherit=True)
    except TabError as error:
        yield Mistake(
            path,
            error.lineno or 0,
            f'Python cannot read this file: {error.msg}',
            'use four spaces for each level everywhere; most editors can convert tabs',
        )
    except SyntaxError as error:
        wrong_bytes = 'utf-8' in (error.msg or '').lower()
        yield Mistake(
            path,
            error.lineno or 0,
            f'Python cannot read this file: {error.msg}',
            'save the file as UTF-8' if wrong_bytes else None,
        )
    except ValueError as error:
        yield Mistake(path, 0, f'Python cannot read this file: {error}', 'save the file as UTF-8 text')


def of_workspace(path: str, packages: list[str]) -> Iterator[Mistake]:
    """Mistakes of the workspace as a whole."""
    for name, signs in BUILD_SIGNS.items():
        folder = os.path.join(path, name)
        if any(os.path.exists(os.path.join(folder, sign)) for sign in signs) and _is_committed(path):
            yield Mistake(
                folder,
                0,
                'colcon made this folder; it belongs to one machine and is ignored here',
                f'put {name}/ into .gitignore, and take it out of the repository with: git rm -r --cached {name}',
            )
    if path in packages and os.path.isdir(os.path.join(path, '.git')):
        yield Mistake(
            os.path.join(path, 'package.xml'),
            0,
            'the package is the root of the repository, which works; it must be cloned into the src/ folder of a workspace',
            None,
        )
    if not packages:
        yield Mistake(
            path,
            0,
            'no package is here: no folder has a package.xml',
            'make one with `edulaunch pkg create NAME`, or name another folder',
        )


def _is_committed(path: str) -> bool:
    """Whether the folder is a repository whose .gitignore does not name build output."""
    try:
        with open(os.path.join(path, '.gitignore'), encoding='utf-8', errors='replace') as file:
            ignored = {line.strip().strip('/') for line in file}
    except OSError:
        ignored = set()
    return os.path.isdir(os.path.join(path, '.git')) and not {'build', 'install', 'log'} & ignored
