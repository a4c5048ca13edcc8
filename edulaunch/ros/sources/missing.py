"""Facts about something that a launch does not find. It may be in the sources without being installed."""

from __future__ import annotations

import ast
import os
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from edulaunch.engine.nearest import nearest_spelling
from edulaunch.engine.packages.reading import PackageWarning, find_packages, read_manifest
from edulaunch.ros.sources.source_package import SourcePackage, install_facts, line_with, parsed, read_text

if TYPE_CHECKING:
    from edulaunch.engine.packages import Index


Facts = dict[str, Any]
_WRITTEN = frozenset(('build', 'install', 'log', 'logs'))
"""Folders that colcon and programs write. They are not searched for packages."""
LOOKED_AT = 500
"""The maximum number of folders below the current one that are searched for a package, because other programs wait meanwhile."""


def missing_package(index: Index, package: str, here: str | None = None) -> Facts:
    """Return facts about a missing package: the nearest name, the folder that contains the package, or the fact that no
    workspace was given.

    :param here: the folder of the program that needs the package. The default is the folder of the running process.
    """
    here = here or os.getcwd()
    workspaces = [place.folder for place in index.workspaces]
    same = [(folder, files) for workspace in workspaces for folder, files in _folders_called(package, workspace)]
    same = [one for one in same if 'package.xml' in one[1] or not find_packages(one[0], [], LOOKED_AT)]
    for folder, files in same:
        if 'package.xml' in files or 'setup.py' in files:
            return _why_no_package(folder, files, workspaces)
    forgotten = None if workspaces else _without_manifest(package, here)
    if forgotten is not None:
        return {'about': 'packages.no-manifest', 'folder': forgotten}
    below = _elsewhere_below(package, workspaces, here)
    if below is not None:
        return {'about': 'packages.not-searched', 'package': package, 'below': below}
    kind = index.absent(package)
    if kind is not None:
        return {'about': 'packages.absent-package', 'package': package, 'belongs_to': kind}
    near = nearest_spelling(package, [name for name in index.packages() if not _is_another(name, package)])
    if near is None and same:
        return _why_no_package(*same[0], workspaces)
    return {'about': 'packages.unknown', 'package': package, 'near': near, 'searched': workspaces}


def _is_another(name: str, package: str) -> bool:
    """Return whether two names differ only in their numbers. For example, turtlebot4_gazebo is not a misspelling of
    turtlebot3_gazebo.
    """
    return name != package and re.sub(r'\d', '0', name) == re.sub(r'\d', '0', package)


def _without_manifest(package: str, here: str) -> str | None:
    """Return the folder of a package without package.xml in a workspace that is not recognised because none of its packages has
    a package.xml.
    """
    for source in ('src', *(os.path.join(name, 'src') for name in sorted(os.listdir(here)))):
        folder = os.path.join(here, source, package)
        if os.path.isfile(os.path.join(folder, 'setup.py')) and not os.path.isfile(os.path.join(folder, 'package.xml')):
            return folder
    return None


def _elsewhere_below(package: str, workspaces: list[str], here: str) -> str | None:
    """Return the relative path of a folder of that name below `here`, or None if a workspace contains the package."""
    for folder in find_packages(here, [], LOOKED_AT) if os.path.dirname(here) != here else ():
        manifest = read_manifest(folder, [])
        if manifest is not None and manifest.name == package and not any(f'{folder}/'.startswith(f'{w}/') for w in workspaces):
            return os.path.relpath(folder, here)
    return None


def _folders_called(name: str, workspace: str) -> Iterator[tuple[str, list[str]]]:
    """Yield each folder of that name, with its files."""
    for folder, folders, files in os.walk(workspace):
        folders[:] = sorted(inner for inner in folders if not inner.startswith('.') and inner.lower() not in _WRITTEN)
        if os.path.basename(folder) == name:
            yield folder, files


def _why_no_package(folder: str, files: list[str], workspaces: list[str]) -> Facts:
    if 'package.xml' not in files:
        templates = [name for name in sorted(files) if name.startswith('package') and name.endswith('.xml') and '1' not in name]
        return {'about': 'packages.no-manifest', 'folder': folder, **({'template': templates[0]} if templates else {})}
    wrong: list[PackageWarning] = []
    if read_manifest(folder, wrong) is None and wrong:
        return _broken(wrong[0])
    above = folder
    while True:  # colcon enters neither a folder with such a file, nor a package
        ignored = next((name for name in ('COLCON_IGNORE', 'AMENT_IGNORE', 'CATKIN_IGNORE') if name in os.listdir(above)), None)
        inside = above if above != folder and os.path.isfile(os.path.join(above, 'package.xml')) else None
        if ignored or inside or above in workspaces or above == os.path.dirname(above):
            return {
                'about': 'packages.not-this-folder',
                'folder': above if ignored else folder,
                'ignored_by': ignored,
                'inside': inside,
            }
        above = os.path.dirname(above)


def _broken(warning: PackageWarning) -> Facts:
    return {'about': 'packages.broken', 'reason': str(warning)}


def source_package(index: Index, package: str) -> SourcePackage | None:
    """Return the package if it is in a source workspace, otherwise None."""
    folder, contents = index.source_folder(package), index.contents(package)
    return None if folder is None or contents is None else SourcePackage(package, folder, contents)


def missing_launch_file(index: Index, package: str, file: str | None) -> Facts:
    """Return facts about a launch file that is in the source of a package but is not installed. Return {} for any other file."""
    found = source_package(index, package)
    if found is None:
        return _built(index, package)
    if found.contents.broken is not None:
        return _broken(found.contents.broken)
    if elsewhere := _installed_elsewhere(found):
        return elsewhere
    installed = {os.path.realpath(path) for path in found.contents.files.values()}
    missing = [
        path
        for path in found.files()
        if os.path.realpath(path) not in installed and found.is_launch_file(path) and file in (None, os.path.basename(path))
    ]
    return _not_installed(found, missing[0]) if missing else {}


def _not_installed(package: SourcePackage, path: str) -> Facts:
    return {'about': 'packages.not-installed', 'source': path, **install_facts(package, path)}


def missing_executable(index: Index, package: str, executable: str) -> Facts:
    """Return facts about a missing executable: the nearest name, or that its source exists but no build file names it."""
    names = [*index.executables(package), *index.native_executables(package)]
    other_ending = [name for name in (f'{executable}.py', executable.removesuffix('.py')) if name in names]
    found = source_package(index, package)
    starts = {os.path.basename(place): entry[0] for place, entry in found.contents.entry_points.items()} if found else {}
    same = other_ending or [name for name in names if starts.get(name, '').endswith(f'.{executable.removesuffix(".py")}')]
    near = same[0] if same else nearest_spelling(executable, names)
    not_built = {} if same else _not_built(index, package, executable)
    return not_built or {
        'about': 'packages.no-executable',
        'package': package,
        'executable': executable,
        'near': near,
        'owner': None if near else _only_owner(index, executable),
        'known': [] if near else names,
        'launch_file': executable if re.search(r'[._]launch\.(py|xml|yaml)$', executable) else None,
        **_unread(index, package, executable),
    }


def _only_owner(index: Index, executable: str) -> str | None:
    """Return the only package that has an executable of that name, or the only package of the workspaces. Otherwise, return
    None.
    """
    owners = [name for name in index.packages() if executable in (*index.executables(name), *index.native_executables(name))]
    own = [name for name in owners if index.source_folder(name) is not None] or owners
    return own[0] if len(own) == 1 else None


def _unread(index: Index, package: str, executable: str) -> Facts:
    """Return the command of CMakeLists.txt that may create an executable, if edulaunch cannot evaluate it."""
    found = source_package(index, package)
    if found is None or found.is_python:
        return {}
    from edulaunch.ros.sources.cmake import KNOWN
    from edulaunch.ros.sources.cmake_text import commands

    called = [
        one.name for one in commands(read_text(found.build_file())) if executable in one.words[:1] and one.name not in KNOWN
    ]
    unread = f'{called[0]}()' if called else found.contents.unread
    return {'unread': unread} if unread else {}


def _not_built(index: Index, package: str, executable: str) -> Facts:
    found = source_package(index, package)
    if found is None:
        return {}
    if found.contents.broken is not None:
        return _broken(found.contents.broken)
    manifest = read_manifest(found.folder, [])
    if found.is_python and (group := _misspelt_group(found)):
        return group
    if found.is_python and manifest is not None and manifest.build_type != 'ament_python':
        reason = f'names the build type {manifest.build_type}, but the package has only a setup.py; write ament_python'
        return _broken(PackageWarning(found.manifest_file, 0, reason))
    if found.is_python and any(not place.startswith(f'lib/{package}/') for place in found.contents.entry_points):
        return {'about': 'packages.no-setup-cfg', 'package': package}
    name = executable.removesuffix('.py')
    for warning in found.contents.warnings:
        if 'console_scripts' in warning.sentence and name in warning.sentence:
            return _broken(warning)
    for path in found.python_files:
        if os.path.basename(path) == f'{name}.py' and 'rclpy' in read_text(path):
            relative = found.relative(path)
            entry = f'{name} = {relative[:-3].replace(os.sep, ".")}:main' if found.is_python else None
            file = os.path.basename(found.build_file())
            program = {'program': relative, 'rename': '' if executable.endswith('.py') else f' RENAME {name}'}
            return {'about': 'packages.no-entry-point', 'source': path, 'entry': entry, 'build_file': file, **program}
    return {}


def _misspelt_group(package: SourcePackage) -> Facts:
    """Return facts about a key of entry_points= that is a misspelling of `console_scripts`. setuptools ignores an unknown
    group.
    """
    tree = parsed(package.build_file())
    for call in ast.walk(tree) if tree is not None else ():
        value = call.value if isinstance(call, ast.keyword) and call.arg == 'entry_points' else None
        for key in value.keys if isinstance(value, ast.Dict) else ():
            if isinstance(key, ast.Constant) and isinstance(key.value, str) and key.value not in GROUPS:
                near = nearest_spelling(key.value, GROUPS[:1])
                if near is not None:
                    place = {'written': os.path.basename(package.build_file()), 'at': key.lineno}
                    return {'about': 'packages.entry-group', 'group': key.value, 'near': near, **place}
    return {}


GROUPS = ('console_scripts', 'gui_scripts')


def _installed_elsewhere(package: SourcePackage) -> Facts:
    """Return facts about a setup.py that installs launch files into the share folder of a name other than the package's."""
    folders = {path.split('/')[1] for path in package.contents.files if path.startswith('share/') and '/launch' in path}
    others = sorted(folders - {'ament_index', package.name})
    if not package.is_python or package.name in folders or not others:
        return {}
    line = line_with(package.build_file(), f"'{others[0]}'") or line_with(package.build_file(), f'"{others[0]}"')
    place = {'written': os.path.basename(package.build_file()), 'at': line or 1}
    return {'about': 'packages.installs-elsewhere', 'package': package.name, 'other': others[0], **place}


def installed_file(index: Index, path: str) -> Facts:
    """Return facts about a missing file in a package's share folder, if the source contains the file but does not install it."""
    head, sign, tail = path.rpartition(f'{os.sep}share{os.sep}')
    package, _, name = tail.partition(os.sep)
    if not (sign and name) or package not in index.packages() or head != index.prefix(package):
        return {}
    found = source_package(index, package)
    source = None if found is None else os.path.join(found.folder, name)
    if source is not None and os.path.isfile(f'{source}.in'):
        return {'about': 'packages.made-by-build', 'template': f'{name}.in', 'made': name}
    if found is None or source is None or not os.path.isfile(source):
        return _built(index, package)
    if found.contents.broken is not None:
        return _broken(found.contents.broken)
    if found.contents.unread:
        return {'about': 'packages.made-by-build', 'template': f'{found.contents.unread} of CMakeLists.txt', 'made': name}
    return _installed_elsewhere(found) or _not_installed(found, source)


def _built(index: Index, package: str) -> Facts:
    """Return facts about a package whose newest files were written after colcon built it."""
    prefix = index.packages().get(package)
    if prefix is None or 'install' not in prefix.split(os.sep):
        return {}
    return {'about': 'packages.built-before', 'package': package, 'prefix': prefix}
