"""Rules about the folders of a workspace, and about files outside of its packages."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from edulaunch.advice.rule import Finding, found, rule

if TYPE_CHECKING:
    from edulaunch.advice.source_package import Workspace

BUILD_SIGNS = {
    'install': ('local_setup.bash', 'setup.bash', '.colcon_install_layout'),
    'build': ('COLCON_IGNORE', '.built_by'),
    'log': ('COLCON_IGNORE', 'latest_build'),
}


@rule(
    'packages.none-here',
    what='{folder} contains no package, because no folder in it has a package.xml',
    why='colcon and ROS 2 recognize a package by its package.xml',
    do='create a package with `ros2 pkg create NAME --build-type ament_python`, or name another folder',
    level='error',
)
def none_here(workspace: Workspace) -> Iterator[Finding]:
    """Report a workspace without packages.

    Other rules report a package.xml that cannot be read, and a folder that colcon skips.
    """
    if not workspace.packages and not workspace.around.warnings and _mark(workspace.path) is None:
        yield found('folder', os.path.basename(workspace.path), file=workspace.path)


@rule(
    'packages.passed-over',
    what='colcon ignores the folder {folder}, because it contains a file {mark}',
    why='colcon builds neither this package nor any package below it',
    do='delete {mark} if colcon should build the package',
    level='info',
)
def passed_over(workspace: Workspace) -> Iterator[Finding]:
    """Report a workspace that colcon skips because of a marker file.

    In this case, the packages are left out on purpose.
    """
    mark = _mark(workspace.path)
    if not workspace.packages and mark is not None:
        yield found('folder', os.path.basename(workspace.path), file=workspace.path, mark=mark)


def _mark(folder: str) -> str | None:
    return next((name for name in ('COLCON_IGNORE', 'AMENT_IGNORE') if os.path.exists(os.path.join(folder, name))), None)


@rule(
    'packages.of-ros-1',
    what='{package} is a package for ROS 1, because its package.xml requires catkin',
    why='colcon cannot build it in a ROS 2 workspace, and its launch files do not run',
    do='look for a version for ROS 2, or add an empty file COLCON_IGNORE to its folder',
    level='info',
)
def of_ros_1(workspace: Workspace) -> Iterator[Finding]:
    """Report a package of ROS 1. No other rule checks such a package."""
    for source in workspace.sources:
        if source.is_of_ros_1:
            yield found('package', source.package.name, file=source.package.manifest_file)


@rule(
    'packages.build-output-committed',
    what='the repository contains {folder}/, which colcon created',
    why='its paths are valid only on the computer where colcon created it',
    do='add {folder}/ to .gitignore, and remove it with `git rm -r --cached {folder}`',
)
def build_output_committed(workspace: Workspace) -> Iterator[Finding]:
    """Report build output in a git repository whose .gitignore does not name it."""
    for name, signs in BUILD_SIGNS.items():
        folder = os.path.join(workspace.path, name)
        if any(os.path.exists(os.path.join(folder, sign)) for sign in signs) and _is_committed(workspace.path):
            yield found('folder', name, file=folder)


def _is_committed(path: str) -> bool:
    try:
        with open(os.path.join(path, '.gitignore'), encoding='utf-8', errors='replace') as file:
            ignored = {line.strip().strip('/') for line in file}
    except OSError:
        ignored = set()
    return os.path.isdir(os.path.join(path, '.git')) and not {'build', 'install', 'log'} & ignored


@rule(
    'packages.build-file',
    what='{file} {said}',
    why='colcon reads this file when it builds the package',
    do=(
        'create {script}: with metadata in setup.cfg or pyproject.toml, `from setuptools import setup; setup()` is enough',
        'create {absent} in the folder of the package, or remove package.xml if this folder is not a package',
        'create the empty file {marker}, which marks an installed package',
        'create the file {lacking}, or remove it from data_files in {file}',
        'write {setting} into the section [install] of {file}',
        'correct line {at} of {file}',
        'correct {file}',
    ),
    level='error',
)
def build_file(workspace: Workspace) -> Iterator[Finding]:
    """Report the problems that edulaunch found when it read package.xml, setup.py, setup.cfg and CMakeLists.txt."""
    for warning in workspace.around.warnings:
        if not warning.about:
            name, line = os.path.basename(warning.file), warning.line or None
            absent = None if os.path.exists(warning.file) else name
            script = absent if absent == 'setup.py' else None
            listed = re.match(r"data_files lists '([^']+)', which is not there", warning.sentence)
            lacking = listed and listed[1]
            is_marker = lacking in {f'resource/{package.name}' for package in workspace.packages}
            facts: dict[str, Any] = {'script': script, 'absent': absent, 'marker': lacking if is_marker else None, 'at': line}
            setting = re.search(r'has no (install_scripts=\S+) in its section', warning.sentence)
            facts |= {'lacking': lacking, 'setting': setting and setting[1]}
            yield found('file', name, file=warning.file, line=line, said=warning.sentence, **facts)


@rule(
    'packages.build-unknown',
    what='{file} {said}',
    why='edulaunch does not run CMake, so it ignores this line',
    do='change nothing: a build knows the value',
    level='info',
)
def build_unknown(workspace: Workspace) -> Iterator[Finding]:
    """Report each build file whose installed files are not known."""
    first = {warning.file: warning for warning in reversed(workspace.around.warnings) if warning.about == 'unknown'}
    for warning in first.values():
        yield found('file', os.path.basename(warning.file), file=warning.file, line=warning.line or None, said=warning.sentence)


@rule(
    'packages.same-name',
    what='two packages have the name {package}; edulaunch uses the one in {other}/ and ignores the one with this {file}',
    why='colcon refuses to build a workspace in which two packages have the same name',
    do='change to the workspace that you mean with cd; within one workspace, change the <name> of one of the two packages',
)
def same_name(workspace: Workspace) -> Iterator[Finding]:
    """Report a package that is left out because another package has the same name."""
    for warning in workspace.around.warnings:
        match = (
            re.match(r"there is a package '(.*)' in (.*)/ already", warning.sentence) if warning.about == 'same name' else None
        )
        if match is not None:
            yield found('file', os.path.basename(warning.file), file=warning.file, package=match[1], other=match[2])
