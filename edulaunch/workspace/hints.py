"""One line of help for what a launch does not find: it is in the sources, but no build would install it."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import TYPE_CHECKING

from edulaunch.nearest import nearest
from edulaunch.packages.manifest import read_manifest
from edulaunch.packages.scan import find_packages
from edulaunch.workspace.layout import install_help
from edulaunch.workspace.sources import SourcePackage, read_text

if TYPE_CHECKING:
    from edulaunch.packages import Index
    from edulaunch.packages.reading import PackageWarning


def package_hint(index: Index, package: str) -> str:
    """For a package that is not found: the nearest name, or where such a folder is, or that no workspace was named."""
    workspaces = [place.folder for place in index.workspaces]
    same = [(folder, files) for workspace in workspaces for folder, files in _folders_called(package, workspace)]
    for folder, files in same:
        if 'package.xml' in files or 'setup.py' in files:
            return _why_no_package(folder, files)
    below = _elsewhere_below(package, workspaces)
    if below is not None:
        return (
            f'{package} lies in {below}, which is not searched from here: go there with cd, or name it with --workspace {below}'
        )
    near = nearest(package, index.packages())
    kind = index.absent(package)
    if kind is not None:
        return f'the package {package!r} ({kind}) is not here'
    if near is not None:
        return f'did you mean the package {near!r}?'
    if same:
        return _why_no_package(*same[0])
    if not workspaces:
        return f'if {package} is a package of yours, go to its workspace (cd) or name that with --workspace DIR'
    return f'no package.xml below {", ".join(workspaces)} has the <name> {package}'


def _elsewhere_below(package: str, workspaces: list[str]) -> str | None:
    """The folder of a package of that name below the current one, as a path from there; None when a workspace has it."""
    here = os.getcwd()
    for folder in find_packages(here, []):
        manifest = read_manifest(folder, [])
        if manifest is not None and manifest.name == package and not any(f'{folder}/'.startswith(f'{w}/') for w in workspaces):
            return os.path.relpath(folder, here)
    return None


def _folders_called(name: str, workspace: str) -> Iterator[tuple[str, list[str]]]:
    """Each folder of that name, with its files."""
    for folder, folders, files in os.walk(workspace):
        folders[:] = sorted(inner for inner in folders if not inner.startswith('.'))
        if os.path.basename(folder) == name:
            yield folder, files


def _why_no_package(folder: str, files: list[str]) -> str:
    if 'package.xml' not in files:
        return f'there is a folder {folder}, but it has no package.xml'
    wrong: list[PackageWarning] = []
    if read_manifest(folder, wrong) is None and wrong:
        return f'{wrong[0].file}:{wrong[0].line}: {wrong[0].sentence}'
    ignored = [name for name in ('COLCON_IGNORE', 'AMENT_IGNORE') if name in files]
    return (
        f'{folder} is left out because of the file {ignored[0]} in it'
        if ignored
        else f'the package.xml in {folder} has another <name>'
    )


def source_package(index: Index, package: str) -> SourcePackage | None:
    """The package as it stands in a source workspace; None when it comes from elsewhere."""
    folder, contents = index.source_folder(package), index.contents(package)
    return None if folder is None or contents is None else SourcePackage(package, folder, contents)


def launch_file_hint(index: Index, package: str, file: str | None) -> str | None:
    """For a launch file that a package does not have: it stands in the source and is not installed."""
    found = source_package(index, package)
    if found is None:
        return _built(index, package)
    if found.contents.broken is not None:
        return str(found.contents.broken)
    installed = {os.path.realpath(path) for path in found.contents.files.values()}
    missing = [
        path
        for path in found.files()
        if os.path.realpath(path) not in installed and found.is_launch_file(path) and file in (None, os.path.basename(path))
    ]
    return f'{missing[0]} is there but not installed: {install_help(found, missing[0])}' if missing else None


def executable_hint(index: Index, package: str, executable: str) -> str | None:
    """For an executable that a package does not have: its source is there, but no entry point or install(PROGRAMS) names it."""
    found = source_package(index, package)
    if found is None:
        return None
    if found.contents.broken is not None:
        return str(found.contents.broken)
    if found.is_python and any(not place.startswith(f'lib/{package}/') for place in found.contents.entry_points):
        return (
            f'setup.cfg does not put executables into lib/{package}; it must have '
            f'[install] with install_scripts=$base/lib/{package}'
        )
    name = executable.removesuffix('.py')
    for path in found.python_files:
        if os.path.basename(path) == f'{name}.py' and 'rclpy' in read_text(path):
            return f'{path} is there, but {_how_to_install(found, path, name)}'
    return None


def _how_to_install(package: SourcePackage, path: str, name: str) -> str:
    if not package.is_python:
        return (
            f'CMakeLists.txt does not install it as a program: add install(PROGRAMS {package.relative(path)} '
            'DESTINATION lib/${PROJECT_NAME})'
        )
    module = package.relative(path)[:-3].replace(os.sep, '.')
    return f"setup.py has no entry point for it: add '{name} = {module}:main' to console_scripts"


def installed_file_hint(index: Index, path: str) -> str | None:
    """For a missing file in the share folder of a package: it stands in the source and is not installed."""
    head, sign, tail = path.rpartition(f'{os.sep}share{os.sep}')
    package, _, name = tail.partition(os.sep)
    if not (sign and name) or package not in index.packages() or head != index.prefix(package):
        return None
    found = source_package(index, package)
    source = None if found is None else os.path.join(found.folder, name)
    if found is None or source is None or not os.path.isfile(source):
        return _built(index, package)
    if found.contents.broken is not None:
        return str(found.contents.broken)
    return f'{source} is there but not installed: {install_help(found, source)}'


def _built(index: Index, package: str) -> str | None:
    """For a package that colcon built: what was written since is not in it."""
    prefix = index.packages().get(package)
    if prefix is None or 'install' not in prefix.split(os.sep):
        return None
    return f'{package} is read from {prefix}; after a change, build it again: colcon build --packages-select {package}'
