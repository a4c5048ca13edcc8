"""Rules about files of a package that are not installed or not valid Python, missing dependencies, and differing package
names.
"""

from __future__ import annotations

import ast
import os
import re
import sys
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from edulaunch.advice.rule import Finding, found, rule
from edulaunch.ros.sources.source_package import DATA_FOLDERS, RUNTIME_TAGS, install_facts, parsed, read_text

if TYPE_CHECKING:
    from edulaunch.advice.source_package import PackageInWorkspace

INSTALL = (
    'move it into the folder {beside}/, where the installed files are',
    "move it to {move}/, and add (os.path.join('share', package_name, '{folder}'), glob('{pattern}')) to data_files of setup.py",
    "add (os.path.join('share', package_name, '{folder}'), glob('{pattern}')) to data_files of setup.py",
    'move it to {move}/, and add install(DIRECTORY {top} DESTINATION share/${{PROJECT_NAME}}) to CMakeLists.txt',
    'add install(DIRECTORY {top} DESTINATION share/${{PROJECT_NAME}}) to CMakeLists.txt',
)


NOT_LAUNCHED = frozenset(('doc', 'docs', 'example', 'examples', 'src'))
"""Folders whose launch files are only read, or are started by their path."""


@rule(
    'packages.launch-file-not-installed',
    what='the build of {package} does not install the launch file {file}',
    why='`ros2 launch {package} {file}` searches only installed files, so it does not find it',
    do=INSTALL,
    lesson='07_packages',
    level='error',
    edits=(('', "(os.path.join('share', package_name, '{folder}'), glob('{pattern}'))", 'data_files'),),
)
def launch_file_not_installed(source: PackageInWorkspace) -> Iterator[Finding]:
    """Report a launch file that a build does not install. Launch tests do not have to be installed.

    The name or the folder of the file shows that it is a launch file.
    """
    package = source.package
    for path in _not_installed(source):
        if package.is_launch_file(path) and os.path.dirname(package.relative(path)).split(os.sep)[0] not in NOT_LAUNCHED:
            yield _of_file(package.name, path, install_facts(package, path))


@rule(
    'packages.data-not-installed',
    what='the build of {package} does not install {file}, so the file is not in the share folder of the package',
    why='a launch file that uses get_package_share_directory() does not find it there',
    do=INSTALL,
    lesson='07_packages',
    edits=(('', "(os.path.join('share', package_name, '{folder}'), glob('{pattern}'))", 'data_files'),),
)
def data_not_installed(source: PackageInWorkspace) -> Iterator[Finding]:
    """Report a file for parameters, robots or worlds that a build does not install, if a launch file or program names it."""
    package = source.package
    written = '\n'.join(_asking_texts(source))
    for path in _not_installed(source):
        if not re.search(rf'(?<![\w.-]){re.escape(os.path.basename(path))}(?!\w)', written):
            continue
        relative = package.relative(path)
        top = relative.split(os.sep)[0]
        # for example a package called `maps`
        is_module = os.path.isfile(os.path.join(path.removesuffix(relative), top, '__init__.py'))
        if (
            top in DATA_FOLDERS
            and not is_module
            and not os.path.basename(path).startswith('.')
            and not package.is_launch_file(path)
        ):
            yield _of_file(package.name, path, install_facts(package, path))


def _asking_texts(source: PackageInWorkspace) -> Iterator[str]:
    """Yield the content, without comments, of the package's files that use a share folder."""
    for text in map(read_text, _used_texts(source)):
        if 'share' in text:
            yield _COMMENT.sub('', text)


def _used_texts(source: PackageInWorkspace) -> Iterator[str]:
    """Yield the paths of the launch files, and of the Python files that a build installs.

    If the installed files are unknown, yield all Python files.
    """
    package, installed = source.package, source.installed
    modules = tuple(package.contents.python_modules.values())
    for path in package.files():
        is_launch = package.is_launch_file(path)
        if package.is_test(path) or not (is_launch or path.endswith('.py')) or path == package.build_file():
            continue
        if is_launch or not source.is_certain or path.startswith(modules) or os.path.realpath(path) in installed:
            yield path


def _not_installed(source: PackageInWorkspace) -> Iterator[str]:
    if source.is_certain:
        installed, build = source.installed, read_text(source.package.build_file())
        excluded = set(re.findall(r'PATTERN\s+"?([^\s"]+)"?\s+EXCLUDE', build))
        files = (path for path in source.package.files() if os.path.basename(path) not in excluded)
        yield from (path for path in files if os.path.realpath(path) not in installed)


def _of_file(package: str, path: str, facts: dict[str, Any]) -> Finding:
    return found('file', os.path.basename(path), file=path, package=package, **facts)


@rule(
    'packages.not-python',
    what='Python cannot read {file}: {said}',
    do=(
        'indent every line of {tabs} with four spaces for each level',
        'save {encoding} as UTF-8',
        'correct this line or a line above it',
    ),
    level='error',
)
def not_python(source: PackageInWorkspace) -> Iterator[Finding]:
    """Report Python files with invalid syntax, tabs that are mixed with spaces, or an encoding other than UTF-8."""
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
"""Modules of Python that no other module imports."""


@rule(
    'packages.hides-python',
    what="the Python package {module} in {package} has the same name as Python's own module {module}",
    why="with ROS 2, Python searches packages first, so a library that imports Python's {module} gets your package instead",
    do='rename it, for example to my_{module}',
)
def hides_python(source: PackageInWorkspace) -> Iterator[Finding]:
    """Report an installed top-level module that hides a module of the standard library."""
    for module, file in source.package.contents.python_modules.items():
        if module in sys.stdlib_module_names and module not in UNUSED:
            yield found('module', module, file=file, package=source.package.name)


FROM_OTHERS = {
    'launch': ('launch_ros', 'launch_testing', 'launch_testing_ros', 'launch_xml', 'launch_yaml', 'ros2launch'),
    'launch_ros': ('launch_testing_ros', 'ros2launch'),
    'launch_xml': ('launch', 'launch_ros', 'ros2launch'),
    'launch_yaml': ('launch', 'launch_ros', 'ros2launch'),
    'ament_index_python': ('launch', 'launch_ros', 'launch_xml', 'launch_yaml', 'ros2launch', 'rclpy'),
    'action_msgs': ('rclpy',),
    'builtin_interfaces': ('rclpy',),
    'unique_identifier_msgs': ('rclpy',),
    'rcl_interfaces': ('rclpy',),
    'ros2launch': ('launch', 'launch_ros'),
}
"""Packages that another package depends on, so package.xml need not name them."""
OF_LAUNCH = frozenset(('launch', 'launch_ros', 'launch_xml', 'launch_yaml'))
"""The dependencies of `ros2launch`. One entry is enough for all of them."""
SAME = {'tf2_ros': ('tf2_ros', 'tf2_ros_py'), 'tf_transformations': ('tf_transformations', 'python3-transforms3d')}
_COMMENT = re.compile(r'<!--.*?-->|^\s*#[^\n]*', re.DOTALL | re.MULTILINE)
_XML_LAUNCHED = re.compile(r"""\bpkg\s*[:=]\s*["']?(\w+)["']?""")


@rule(
    'packages.dependency-missing',
    what=(
        '{dependency} is {how} here, but package.xml names it only as {tags}',
        '{dependency} is {how} here, but package.xml does not name it',
    ),
    why='rosdep installs only the packages that package.xml names, so this one can be missing on another computer',
    do='add <exec_depend>{dependency}</exec_depend> to package.xml',
    lesson='07_packages',
    edits=(('', '<exec_depend>{dependency}</exec_depend>', 'manifest'),),
)
def dependency_missing(source: PackageInWorkspace) -> Iterator[Finding]:
    """Report each package once that a file imports or launches, but that package.xml does not list as a dependency."""
    for name, file, line, how in _missing(source):
        if not _is_of_launch(name, file):
            tags = [f'<{one.tag}>' for one in source.package.dependencies if one.name == name]
            yield found('dependency', name, file=file, line=line, how=how, tags=tags)


@rule(
    'packages.launch-not-named',
    what='a launch file uses {dependency}, but package.xml names no package that installs it',
    why='rosdep installs only the packages that package.xml names; if `ros2 launch` works, {dependency} is already installed',
    do='add <exec_depend>ros2launch</exec_depend> to package.xml, which installs launch and launch_ros',
    lesson='07_packages',
    edits=(('', '<exec_depend>ros2launch</exec_depend>', 'manifest'),),
    level='info',
)
def launch_not_named(source: PackageInWorkspace) -> Iterator[Finding]:
    """Report a package whose launch files need dependencies that package.xml does not list. Name only the first dependency."""
    used = [(name not in OF_LAUNCH, name, file, line) for name, file, line, _ in _missing(source) if _is_of_launch(name, file)]
    for _, name, file, line in sorted(used)[:1]:
        yield found('dependency', name, file=file, line=line)


def _is_of_launch(name: str, file: str) -> bool:
    return name in OF_LAUNCH or name == 'ament_index_python' and 'launch' in file


def _missing(source: PackageInWorkspace) -> Iterator[tuple[str, str, int, str]]:
    package = source.package
    declared = {dependency.name for dependency in package.dependencies if dependency.tag in RUNTIME_TAGS}
    known = source.around.packages()
    reported: set[str] = {package.name, *package.contents.python_modules}
    for name, file, line, how in _uses(source):
        if name not in reported and name in known and not declared & {name, *SAME.get(name, ()), *FROM_OTHERS.get(name, ())}:
            reported.add(name)
            yield name, file, line, how


def _uses(source: PackageInWorkspace) -> Iterator[tuple[str, str, int, str]]:
    """Yield (package, file, line, 'imported' or 'launched') for each use of a package, in the order of files and lines."""
    launched: list[tuple[str, str, int, str]] = []
    for path in _used_texts(source):
        is_launch = source.package.is_launch_file(path)
        if not path.endswith('.py'):
            launched += ((name, path, line, 'launched') for line, name in _launched_by_markup(path))
            continue
        for node in ast.walk(parsed(path) or ast.Module([], [])):
            if isinstance(node, ast.Import):
                yield from ((alias.name.partition('.')[0], path, node.lineno, 'imported') for alias in node.names)
            elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
                yield node.module.partition('.')[0], path, node.lineno, 'imported'
            elif is_launch and isinstance(node, ast.keyword) and node.arg == 'package' and isinstance(node.value, ast.Constant):
                launched.append((str(node.value.value), path, node.value.lineno, 'launched'))
    yield from launched


def _launched_by_markup(path: str) -> Iterator[tuple[int, str]]:
    """Yield (line, package) for each package that an XML or YAML launch file uses. Skip comments."""
    text = _COMMENT.sub(lambda found: '\n' * found[0].count('\n'), read_text(path))
    for number, line in enumerate(text.splitlines(), 1):
        yield from ((number, name) for name in _XML_LAUNCHED.findall(line))


_SETUP_NAME = re.compile(r"""^\s*(?:package_name|name)\s*=\s*['"]([\w.-]+)['"]""", re.MULTILINE)
_PROJECT = re.compile(r'^\s*project\s*\(\s*([\w.-]+)', re.MULTILINE | re.IGNORECASE)


@rule(
    'packages.name-differs',
    what="package.xml calls the package '{package}', but {written} calls it '{other}'",
    why=(
        'colcon uses the name in package.xml, but setup.py installs files into {place}',
        'ament_package() stops the build if the two names differ',
    ),
    do=("write '{folder}' in both files", "write '{package}' in both files"),
    lesson='07_packages',
    level='error',
)
def name_differs(source: PackageInWorkspace) -> Iterator[Finding]:
    """Report a package name in setup.py, or in project() of CMakeLists.txt, that differs from the name in package.xml."""
    package = source.package
    build = package.build_file()
    pattern = _SETUP_NAME if package.is_python else _PROJECT
    named = pattern.search(read_text(build))
    if named is not None and named[1] != package.name:
        place = f'share/{named[1]}/' if package.is_python else None
        if place is not None and not any(name.startswith(place) for name in package.contents.files):
            return  # only the build itself uses the other name
        line = read_text(build).count('\n', 0, named.start(1)) + 1
        folder = os.path.basename(os.path.dirname(build))
        facts: dict[str, Any] = {'other': named[1], 'written': os.path.basename(build), 'place': place}
        yield found('package', package.name, file=build, line=line, folder=folder if folder == named[1] else None, **facts)
