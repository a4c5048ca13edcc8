"""What the code needs at run time and package.xml does not name."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from edulaunch.advice.finding import Finding, found
from edulaunch.advice.rule import rule
from edulaunch.workspace.sources import RUNTIME_TAGS, SourcePackage, parsed

if TYPE_CHECKING:
    from edulaunch.advice.source_package import Source

FROM_OTHERS = {
    'launch_xml': 'launch',
    'launch_yaml': 'launch',
    'action_msgs': 'rclpy',
    'builtin_interfaces': 'rclpy',
    'unique_identifier_msgs': 'rclpy',
    'rcl_interfaces': 'rclpy',
    'ros2launch': 'launch',
}
"""Packages that come with another one, so that nobody misses them in a package.xml."""
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
    do='add <exec_depend>{dependency}</exec_depend> to package.xml',
    lesson='05_large_project',
)
def dependency_missing(source: Source) -> Iterator[Finding]:
    """Packages that are imported or launched; each once, where it is first used."""
    package = source.package
    declared = {dependency.name for dependency in package.dependencies if dependency.tag in RUNTIME_TAGS}
    known = source.around.packages()
    told: set[str] = {package.name}
    for name, file, line, how in _uses(package):
        if name in told or name not in known or declared & {name, *SAME.get(name, ())} or FROM_OTHERS.get(name) in declared:
            continue
        told.add(name)
        tags = [f'<{one.tag}>' for one in package.dependencies if one.name == name]
        yield found('dependency', name, file=file, line=line, how=how, tags=tags)


def _uses(package: SourcePackage) -> Iterator[tuple[str, str, int, str]]:
    """(package, file, line, 'imported' or 'launched') in order of files and lines."""
    for path in package.python_files:
        tree = parsed(path)
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
