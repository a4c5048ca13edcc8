"""Files of a package: what no build installs, and what Python cannot read; what the code needs at run time and package.xml
does not name; and the name of a package, which stands in several files and must be the same in all.
"""

from __future__ import annotations

import ast
import os
import re
import sys
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from edulaunch.advice.rule import Finding, found, rule
from edulaunch.ros.sources.source_package import DATA_FOLDERS, RUNTIME_TAGS, SourcePackage, install_facts, parsed, read_text

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
    lesson='07_packages',
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
    lesson='07_packages',
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
    is_certain = not any(warning.about == 'unknown' for warning in source.package.contents.warnings)
    if source.is_readable and is_certain:
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


UNUSED = frozenset(('antigravity', 'idlelib', 'this', 'turtle', 'turtledemo'))
"""Modules of Python's that no other module imports."""


@rule(
    'packages.hides-python',
    what="the Python package {module} of {package} is named like Python's own module {module}",
    why="with ROS 2 the folders of packages come first: whatever imports Python's {module}, as numpy or rclpy may do, gets yours",
    do='give it another name, such as my_{module}',
)
def hides_python(source: Source) -> Iterator[Finding]:
    """Top-level modules that a package of Python installs."""
    for module, file in source.package.contents.python_modules.items():
        if module in sys.stdlib_module_names and module not in UNUSED:
            yield found('module', module, file=file, package=source.package.name)


FROM_OTHERS = {
    'launch': ('launch_ros', 'launch_testing', 'launch_testing_ros', 'launch_xml', 'launch_yaml', 'ros2launch'),
    'launch_ros': ('launch_testing_ros', 'ros2launch'),
    'launch_xml': ('launch', 'launch_ros', 'ros2launch'),
    'launch_yaml': ('launch', 'launch_ros', 'ros2launch'),
    'action_msgs': ('rclpy',),
    'builtin_interfaces': ('rclpy',),
    'unique_identifier_msgs': ('rclpy',),
    'rcl_interfaces': ('rclpy',),
    'ros2launch': ('launch', 'launch_ros'),
}
"""Packages that come with another one, so that nobody misses them in a package.xml."""
OF_LAUNCH = frozenset(('launch', 'launch_ros', 'launch_xml', 'launch_yaml'))
"""What `ros2launch` brings: one entry is enough for all of them."""
SAME = {'tf2_ros': ('tf2_ros', 'tf2_ros_py'), 'tf_transformations': ('tf_transformations', 'python3-transforms3d')}
_LAUNCHED = re.compile(r"""package\s*=\s*["'](\w+)["']""")
_XML_LAUNCHED = re.compile(r"""\bpkg\s*[:=]\s*["']?(\w+)["']?""")


@rule(
    'packages.dependency-missing',
    what=(
        '{dependency} is {how} here, but package.xml names it only as {tags}',
        '{dependency} is {how} here, but package.xml does not name it',
    ),
    why='rosdep installs what package.xml names: on another machine it is missing',
    do=(
        'add <exec_depend>{bringer}</exec_depend> to package.xml: it brings launch and launch_ros',
        'add <exec_depend>{dependency}</exec_depend> to package.xml',
    ),
    lesson='07_packages',
)
def dependency_missing(source: Source) -> Iterator[Finding]:
    """Packages that are imported or launched; each once, where it is first used."""
    package = source.package
    declared = {dependency.name for dependency in package.dependencies if dependency.tag in RUNTIME_TAGS}
    known = source.around.packages()
    told: set[str] = {package.name}
    for name, file, line, how in _uses(package):
        if name in told or name not in known or declared & {name, *SAME.get(name, ()), *FROM_OTHERS.get(name, ())}:
            continue
        is_of_launch = name in OF_LAUNCH
        told |= OF_LAUNCH if is_of_launch else {name}
        tags = [f'<{one.tag}>' for one in package.dependencies if one.name == name]
        yield found('dependency', name, file=file, line=line, how=how, tags=tags, bringer='ros2launch' if is_of_launch else None)


def _uses(package: SourcePackage) -> Iterator[tuple[str, str, int, str]]:
    """(package, file, line, 'imported' or 'launched') in order of files and lines."""
    for path in package.python_files:
        tree = None if package.is_test(path) else parsed(path)
        if tree is None:
            continue
        for node in ast.walk(tree):
            if isinstance(node, ast.Import):
                yield from ((alias.name.partition('.')[0], path, node.lineno, 'imported') for alias in node.names)
            elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
                yield node.module.partition('.')[0], path, node.lineno, 'imported'
    for path in package.files():
        if package.is_launch_file(path):
            pattern = _LAUNCHED if path.endswith('.py') else _XML_LAUNCHED
            with open(path, encoding='utf-8', errors='replace') as file:
                for number, text in enumerate(file, 1):
                    yield from ((name, path, number, 'launched') for name in pattern.findall(text))


_SETUP_NAME = re.compile(r"""^\s*(?:package_name|name)\s*=\s*['"]([\w.-]+)['"]""", re.MULTILINE)
_PROJECT = re.compile(r'^\s*project\s*\(\s*([\w.-]+)', re.MULTILINE | re.IGNORECASE)


@rule(
    'packages.name-differs',
    what="package.xml calls the package '{package}', {written} calls it '{other}'",
    why='what is built under one name is looked for under the other',
    do="write '{package}' in both",
    lesson='07_packages',
    level='error',
)
def name_differs(source: Source) -> Iterator[Finding]:
    """By `package_name =` or `name=` in setup.py, or project() in CMakeLists.txt."""
    package = source.package
    build = package.build_file()
    pattern = _SETUP_NAME if package.is_python else _PROJECT
    named = pattern.search(read_text(build))
    if named is not None and named[1] not in (package.name, package.name.replace('_', '-')):
        line = read_text(build).count('\n', 0, named.start(1)) + 1
        yield found('package', package.name, file=build, line=line, other=named[1], written=os.path.basename(build))
