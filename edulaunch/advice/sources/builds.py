"""Rules about outdated builds, and about scripts that CMake packages install as programs."""

from __future__ import annotations

import ast
import glob
import os
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from edulaunch.advice.rule import Finding, found, rule
from edulaunch.ros.sources.source_package import parsed, read_text

if TYPE_CHECKING:
    from edulaunch.advice.source_package import PackageInWorkspace

LEVELS_ABOVE = 4
"""The number of folders above a package that are searched for its workspace."""


@rule(
    'packages.changed-after-build',
    what='{package} has changed since it was built: {changed}',
    why='a real ROS 2 runs the files that colcon installed, but edulaunch runs the sources, which contain the change',
    do='build it again in {workspace} with `colcon build --packages-select {package}`, or once with --symlink-install',
    level='info',
    lesson='07_packages',
)
def changed_after_build(source: PackageInWorkspace) -> Iterator[Finding]:
    """Report source files that are not installed, or that differ from the installed files. The rule compares contents, not times.

    Links always lead to the sources. So do the files that `--symlink-install` writes in place of modules.
    """
    package = source.package
    prefix, workspace = _installed_prefix(package.folder, package.name)
    if prefix is None or not source.is_readable:
        return
    files = package.contents.files.items()
    pairs = {os.path.join(prefix, name): path for name, path in files if not name.startswith('share/ament_index/')}
    for place in glob.glob(os.path.join(glob.escape(prefix), 'lib', 'python3*', 'site-packages')):
        is_linked = any(name.endswith('.egg-link') for name in os.listdir(place))
        for top, folder in () if is_linked else package.contents.python_modules.items():
            inside = [path for path in package.python_files if path.startswith(folder + os.sep)]
            built = {os.path.join(place, top, os.path.relpath(path, folder)): path for path in inside}
            # setup() may leave out a folder that is missing in the build
            pairs.update({name: path for name, path in built.items() if os.path.isdir(os.path.dirname(name))})
    changed = [package.relative(path) for built, path in pairs.items() if not _is_equal(built, path)]
    if changed:
        first = os.path.join(package.folder, changed[0])
        yield found('package', package.name, file=first, changed=changed[:3], workspace=os.path.basename(workspace))


def _installed_prefix(folder: str, package: str) -> tuple[str | None, str]:
    """Return the prefix into which colcon installed a package, and the workspace. Without a build, return None as the prefix.

    The prefix may belong to this package alone, or to all packages.
    """
    for _ in range(LEVELS_ABOVE):
        folder = os.path.dirname(folder)
        for prefix in (os.path.join(folder, 'install', package), os.path.join(folder, 'install')):
            if os.path.isfile(os.path.join(prefix, 'share', package, 'package.xml')):
                return prefix, folder
    return None, folder


def _is_equal(built: str, path: str) -> bool:
    """Return whether the installed file is a link to the source file or has the same content."""
    if os.path.islink(built) or not os.path.isfile(path) or os.path.realpath(built) == os.path.realpath(path):
        return True
    try:
        with open(built, 'rb') as one, open(path, 'rb') as other:
            return one.read() == other.read()
    except OSError:
        return False


LESSON = '07_packages'
INSTALL = 'add install(PROGRAMS {written} DESTINATION lib/${{PROJECT_NAME}}) to CMakeLists.txt'


@rule(
    'packages.no-shebang',
    what='the first line of the program {file} does not name its interpreter',
    why='`ros2 run {package} {file}` fails with "Exec format error"',
    do='write this first line: #!/usr/bin/env python3',
    lesson=LESSON,
    level='error',
)
def no_shebang(source: PackageInWorkspace) -> Iterator[Finding]:
    """Report a script without `#!` that CMakeLists.txt installs as a program."""
    programs = _programs(source)
    for path, text in _scripts(source):
        if os.path.realpath(path) in programs and _runs(text) and not text.startswith('#!'):
            yield _of_file(source, path, 1)


@rule(
    'packages.program-not-installed',
    what='the build of {package} does not install the program {file}',
    why='`ros2 run {package} {file}` does not find it',
    do=INSTALL,
    lesson=LESSON,
    level='error',
)
def program_not_installed(source: PackageInWorkspace) -> Iterator[Finding]:
    """Report a script that starts rclpy and is not installed.

    The rule applies if a launch file of the package starts the script, or if the package installs no program.
    """
    launched, has_none = executables_launched(source), not _programs(source) and not source.package.contents.native
    for path in _left_out(source):
        if has_none or os.path.basename(path) in launched:
            yield _of_file(source, path)


@rule(
    'packages.program-left-out',
    what='{file} starts a node, but the build of {package} does not install it',
    why='`ros2 run {package} {file}` does not find it, but `python3 {file}` works',
    do=INSTALL + ' if you want to start it with `ros2 run`',
    lesson=LESSON,
    level='info',
)
def program_left_out(source: PackageInWorkspace) -> Iterator[Finding]:
    """Report a script that is not installed, in a package that installs other programs. Such a script may be left out on
    purpose.
    """
    launched, has_none = executables_launched(source), not _programs(source) and not source.package.contents.native
    for path in _left_out(source):
        if not has_none and os.path.basename(path) not in launched:
            yield _of_file(source, path)


def _left_out(source: PackageInWorkspace) -> Iterator[str]:
    """Yield the scripts that start rclpy, if no build installs them and they are not modules of a Python package."""
    installed = source.installed
    modules = tuple(place + os.sep for place in source.package.contents.python_modules.values())
    for path, text in _scripts(source) if source.is_certain else ():
        place = installed.get(os.path.realpath(path), '')
        is_hidden = os.path.basename(path).startswith('.')
        if 'rclpy.init' in text and not is_hidden and not path.startswith(modules) and not place:
            yield path


def executables_launched(source: PackageInWorkspace) -> set[str]:
    """Return the values of `executable` or `exec` in the launch files of a package, and the modules after `python3 -m`."""
    texts = (read_text(path) for path in source.package.files() if source.package.is_launch_file(path))
    return {name for text in texts for name in _EXECUTABLE.findall(text)}


_EXECUTABLE = re.compile(r"""(?:\bexec(?:utable)?\s*[=:]|["'\s]-m["',]*)\s*["']?([\w.-]+)""")


@rule(
    'packages.program-not-executable',
    what='CMake installs {file} without the execute permission',
    why='`ros2 run {package} {file}` finds only executable files',
    do='replace install(FILES ...) in CMakeLists.txt with install(PROGRAMS {written} DESTINATION lib/${{PROJECT_NAME}})',
    lesson=LESSON,
    level='error',
)
def program_not_executable(source: PackageInWorkspace) -> Iterator[Finding]:
    """Report a script below lib/ that is installed without the permission to execute it, as install(FILES) does."""
    installed, programs = source.installed, _programs(source)
    modules = tuple(place + os.sep for place in source.package.contents.python_modules.values())
    for path, text in _scripts(source):
        real = os.path.realpath(path)
        is_plain = installed.get(real, '').startswith('lib/') and real not in programs
        if is_plain and 'rclpy.init' in text and not path.startswith(modules):
            yield _of_file(source, path)


@rule(
    'packages.main-never-called',
    what='the program {file} defines main() but never calls it',
    why='`ros2 run {package} {file}` ends at once without a message',
    do="write `if __name__ == '__main__': main()` at the end of the file",
    lesson=LESSON,
    level='error',
)
def main_never_called(source: PackageInWorkspace) -> Iterator[Finding]:
    """Report an installed program with a function main, if no top-level statement of the module calls a function."""
    programs = _programs(source)
    for path, text in _scripts(source):
        tree = parsed(path) if os.path.realpath(path) in programs and 'def main' in text else None
        if tree is not None and not any(map(_calls, tree.body)):
            yield _of_file(source, path, next((one.lineno for one in tree.body if getattr(one, 'name', '') == 'main'), None))


def _calls(statement: ast.stmt) -> bool:
    """Return whether a top-level statement calls a function when the module runs."""
    if isinstance(statement, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef, ast.Import, ast.ImportFrom, ast.Assign)):
        return False
    return any(isinstance(node, ast.Call) for node in ast.walk(statement))


def _scripts(source: PackageInWorkspace) -> Iterator[tuple[str, str]]:
    """Yield (path, content) of the readable Python files of a CMake package, without tests."""
    if source.is_readable and not source.package.is_python:
        package = source.package
        yield from ((path, read_text(path)) for path in package.python_files if not package.is_test(path))


def _programs(source: PackageInWorkspace) -> set[str]:
    contents = source.package.contents
    return {os.path.realpath(contents.files[name]) for name in contents.programs}


def _runs(text: str) -> bool:
    return '\nif __name__' in text or 'rclpy.init' in text


def _of_file(source: PackageInWorkspace, path: str, line: int | None = None) -> Finding:
    written = source.package.relative(path)
    return found('file', os.path.basename(path), file=path, line=line, package=source.package.name, written=written)
