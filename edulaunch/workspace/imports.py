"""Mistakes of package.xml: what the code needs at run time and the manifest does not name."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator

from edulaunch.packages import Index
from edulaunch.workspace.finding import Mistake
from edulaunch.workspace.sources import RUNTIME_TAGS, SourcePackage, parsed

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


def of_package(index: Index, package: SourcePackage) -> Iterator[Mistake]:
    """Packages that are imported or launched and not named in package.xml; each once, where it is first used."""
    declared = {dependency.name for dependency in package.dependencies if dependency.tag in RUNTIME_TAGS}
    others = {dependency.name for dependency in package.dependencies} - declared
    known = index.packages()
    told: set[str] = {package.name}
    for name, file, line, how in _uses(package):
        if name in told or name not in known or declared & {name, *SAME.get(name, ())} or FROM_OTHERS.get(name) in declared:
            continue
        told.add(name)
        only = f' (it is named for another purpose only: {_tags(package, name)})' if name in others else ''
        yield Mistake(
            file,
            line,
            f'{name} is {how} here, but package.xml does not name it{only}',
            f'add <exec_depend>{name}</exec_depend> to package.xml',
        )


def _tags(package: SourcePackage, name: str) -> str:
    return ', '.join(f'<{dependency.tag}>' for dependency in package.dependencies if dependency.name == name)


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
