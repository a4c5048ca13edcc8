"""Files of a package: what no build installs, and what Python cannot read."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from edulaunch.advice.finding import Finding, found
from edulaunch.advice.rule import rule
from edulaunch.workspace.sources import DATA_FOLDERS, install_facts

if TYPE_CHECKING:
    from edulaunch.advice.source_package import Source

INSTALL = (
    'move it into the folder {beside}/, as the files that are installed',
    "move it to {move}/, and add (os.path.join('share', package_name, '{folder}'), glob('{pattern}')) to data_files of setup.py",
    "add (os.path.join('share', package_name, '{folder}'), glob('{pattern}')) to data_files of setup.py",
    'move it to {move}/, and add install(DIRECTORY {top} DESTINATION share/${{PROJECT_NAME}}) to CMakeLists.txt',
    'add install(DIRECTORY {top} DESTINATION share/${{PROJECT_NAME}}) to CMakeLists.txt',
)


@rule(
    'packages.launch-file-not-installed',
    what='no build installs the launch file {file}',
    why='"ros2 launch {package} {file}" looks only at what is installed, and does not find it',
    do=INSTALL,
    lesson='05_large_project',
    level='error',
)
def launch_file_not_installed(source: Source) -> Iterator[Finding]:
    """A launch file by its name or its folder; descriptions of launch tests need not be installed."""
    package = source.package
    for path in _not_installed(source):
        if package.is_launch_file(path):
            yield _of_file(package.name, path, install_facts(package, path))


@rule(
    'packages.data-not-installed',
    what='no build installs {file}, so it is not in the share folder of {package}',
    why='a launch file that asks for it by get_package_share_directory() does not find it',
    do=INSTALL,
    lesson='05_large_project',
)
def data_not_installed(source: Source) -> Iterator[Finding]:
    """Files of the folders in which packages keep parameters, robots and worlds."""
    package = source.package
    for path in _not_installed(source):
        relative = package.relative(path)
        top = relative.split(os.sep)[0]
        is_module = os.path.isfile(os.path.join(path.removesuffix(relative), top, '__init__.py'))  # a package called `maps`
        if (
            top in DATA_FOLDERS
            and not is_module
            and not os.path.basename(path).startswith('.')
            and not package.is_launch_file(path)
        ):
            yield _of_file(package.name, path, install_facts(package, path))


def _not_installed(source: Source) -> Iterator[str]:
    if source.is_readable:
        installed = source.installed
        yield from (path for path in source.package.files() if os.path.realpath(path) not in installed)


def _of_file(package: str, path: str, facts: dict[str, Any]) -> Finding:
    return found('file', os.path.basename(path), file=path, package=package, **facts)


@rule(
    'packages.not-python',
    what='Python cannot read {file}: {said}',
    do=(
        'indent every line of {tabs} with spaces, four for each level',
        'save {encoding} as UTF-8',
        'correct the line, or one above it',
    ),
    level='error',
)
def not_python(source: Source) -> Iterator[Finding]:
    """Wrong syntax, tabs mixed with spaces, another encoding than UTF-8."""
    for path in source.package.python_files:
        name = os.path.basename(path)
        try:
            with open(path, 'rb') as file:
                compile(file.read(), path, 'exec', dont_inherit=True)
        except SyntaxError as error:
            tabs = name if isinstance(error, TabError) else None
            encoding = name if 'utf-8' in (error.msg or '').lower() else None
            yield found('file', name, file=path, line=error.lineno or None, said=error.msg, tabs=tabs, encoding=encoding)
        except ValueError as error:
            yield found('file', name, file=path, said=str(error), encoding=name)
