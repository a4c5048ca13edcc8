"""The house as the tests of its form see it: its Python files by module name, who imports whom, and how long everything is."""

from __future__ import annotations

import ast
import gc
import os
from collections.abc import Iterator
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PACKAGE = ROOT / 'edulaunch'
EXAMPLES = 100 if os.environ.get('EDULAUNCH_THOROUGH') else 40
"""How many a test of a property tries, where it says nothing else; others try so many times that."""
UNDERLAY = PACKAGE / 'ros' / 'python'
WITH_ROOMS = ('engine', 'ros', 'runtime', 'advice', 'desk', 'extras')
"""Wings of several rooms; each other wing is one room."""
AS_PREFIX = ('bin', 'programs', 'python', 'share')
"""What of the wing `ros` is an install prefix, and no package of edulaunch."""
RULES = ('advice.errors', 'advice.plans', 'advice.recordings', 'advice.scripts', 'advice.sources', 'advice.workspaces')
"""Folders of rules, which are no rooms of their own."""
ROOMS_OF_ADVICE = ('plan', 'explaining', 'workspace')
"""What else is in the wing of advice are rules."""
FACADE = ('__main__', 'jupyter')
FACES = sorted(path.name for path in UNDERLAY.iterdir() if path.is_dir() and path.name != '__pycache__')


@cache
def modules() -> dict[str, Path]:
    """Every module of edulaunch, the grader and the underlay's ROS packages."""
    places = [(ROOT, ['edulaunch']), (ROOT / 'grader', ['edugrade', 'checks']), (UNDERLAY, FACES)]
    return {
        _module_name(path.relative_to(base)): path
        for base, packages in places
        for package in packages
        for path in sorted((base / package).rglob('*.py'))
        if PACKAGE / 'ros' not in path.parents or base != ROOT or path.relative_to(PACKAGE / 'ros').parts[0] not in AS_PREFIX
    }


def _module_name(path: Path) -> str:
    parts = path.with_suffix('').parts
    return '.'.join(parts[:-1] if parts[-1] == '__init__' else parts)


def room(module: str) -> str:
    """The room that a module is in, a package of a wing: `edulaunch.engine.sim`, `edulaunch.canvas`, `edugrade`, `rclpy`."""
    parts = module.split('.')
    if parts[0] != 'edulaunch':
        return parts[0]
    is_inside = len(parts) > 2 and parts[1] in WITH_ROOMS and (parts[1] != 'advice' or parts[2] in ROOMS_OF_ADVICE)
    return '.'.join(parts[: 3 if is_inside else 2])


def wing(module: str) -> str:
    """The wing that a module is in: `edulaunch.engine`, `edulaunch.ros`, `grader`; the facade is one for itself."""
    parts = module.split('.')
    if parts[0] in ('edugrade', 'checks'):
        return 'grader'
    if parts[0] != 'edulaunch':
        return 'edulaunch.ros'
    return 'facade' if len(parts) == 1 or parts[1] in FACADE else '.'.join(parts[:2])


@cache
def tree(path: Path) -> ast.Module:
    """The file, parsed once. While it is parsed the collector rests, and afterwards it leaves the tree alone: looking for garbage
    among a million nodes that all stay takes three times as long as reading them.
    """
    was_on = gc.isenabled()
    gc.disable()
    try:
        return ast.parse(path.read_text(encoding='utf-8'))
    finally:
        gc.freeze()
        if was_on:
            gc.enable()


@cache
def nodes(path: Path) -> tuple[ast.AST, ...]:
    """Every node of the file, in the order of `ast.walk`."""
    return tuple(ast.walk(tree(path)))


@cache
def imports(module: str, *, with_types: bool = True) -> frozenset[str]:
    """The modules of the house that a module imports anywhere, in functions and by name too.

    :param with_types: whether imports under `TYPE_CHECKING`, which never run, count.
    """
    known = modules()
    found = {_longest_known(name, known) for name in _names(tree(known[module]), _package(module), with_types)}
    return frozenset(found) - {None, module}  # type: ignore[return-value]


def every_import(path: Path) -> Iterator[str]:
    """Absolute names of everything that a file imports, of the house or not."""
    return _names(tree(path), '', True)


def _package(module: str) -> str:
    return module if modules()[module].name == '__init__.py' else module.rpartition('.')[0]


def _names(node: ast.AST, package: str, with_types: bool) -> Iterator[str]:
    for child in ast.iter_child_nodes(node):
        if not with_types and isinstance(child, ast.If) and _last_name(child.test) == 'TYPE_CHECKING':
            continue
        if _only_names(child):
            continue
        if isinstance(child, ast.Import):
            yield from (alias.name for alias in child.names)
        elif isinstance(child, ast.ImportFrom):
            base = '.'.join([*_parent(package, child.level), *([child.module] if child.module else [])])
            yield from (f'{base}.{alias.name}' for alias in child.names)
        elif isinstance(child, ast.Constant) and isinstance(child.value, str):
            if '.' in child.value and child.value.partition(':')[0] in modules():
                yield child.value.partition(':')[0]
        else:
            yield from _names(child, package, with_types)


def _only_names(node: ast.AST) -> bool:
    """Whether a text in it names a module as ROS does, and nothing is loaded: of a class, of a logger, of a group of entry points."""
    if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name):
        return node.targets[0].id in ('__module__', 'PARSER_GROUP')
    return isinstance(node, ast.Call) and _last_name(node.func) == 'get_logger'


def _last_name(node: ast.expr) -> str:
    return node.attr if isinstance(node, ast.Attribute) else node.id if isinstance(node, ast.Name) else ''


def _parent(package: str, level: int) -> list[str]:
    parts = package.split('.')
    return parts[: len(parts) - level + 1] if level else []


def _longest_known(name: str, known: dict[str, Path]) -> str | None:
    while name and name not in known:
        name = name.rpartition('.')[0]
    return name or None


def circles(arrows: dict[str, set[str]]) -> list[list[str]]:
    """Groups in which everybody reaches everybody (strongly connected components of more than one), each sorted."""

    def reached(start: str) -> set[str]:
        seen: set[str] = set()
        ahead = [start]
        while ahead:
            ahead += (new := arrows.get(ahead.pop(), set()) - seen)
            seen |= new
        return seen

    ways = {name: reached(name) for name in arrows}
    groups = {
        tuple(sorted(other for other in ways[name] if name in ways.get(other, ()))) for name in arrows if name in ways[name]
    }
    return [list(group) for group in sorted(groups)]


def code_lines(path: Path) -> int:
    """Lines with code: without blank lines, comments and docstrings."""
    text = path.read_text(encoding='utf-8').split('\n')
    lines = {number for number, line in enumerate(text, 1) if line.strip() and not line.lstrip().startswith('#')}
    docstrings: set[int] = set()
    for node in nodes(path):
        if isinstance(node, (ast.Constant, ast.JoinedStr)) and node.end_lineno is not None:
            lines.update(range(node.lineno, node.end_lineno + 1))
        elif isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)):
            docstrings |= _docstring(node)
    return len(lines - docstrings)


def _docstring(node: ast.Module | ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef) -> set[int]:
    if ast.get_docstring(node, clean=False) is None:
        return set()
    first = node.body[0]
    return set(range(first.lineno, (first.end_lineno or first.lineno) + 1))


def long_functions(path: Path, most: int) -> Iterator[tuple[str, int]]:
    """(name, code lines) of the functions of a file that are longer, inner functions counted with them."""
    for node in nodes(path):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            length = (node.end_lineno or node.lineno) - node.lineno + 1 - len(_docstring(node))
            if length > most:
                yield node.name, length


NAMED_SO_BY_THE_LANGUAGE = {'_replace', '_asdict', '_fields', '_make', '_fields_', '_exit', '_getframe', '_current_frames'}
"""Attributes with an underscore that Python's library reference documents: of named tuples, ctypes, `os` and `sys`."""
NAMED_SO_BY_ROS = {
    **dict.fromkeys(
        ('_push_locals', '_pop_locals', '_event_queue', '_completion_futures', '_set_is_shutdown', '_set_asyncio_loop'),
        'LaunchContext: launch.LaunchService and the tests of launch call it',
    ),
    **dict.fromkeys(
        (
            '_push_launch_configurations',
            '_pop_launch_configurations',
            '_push_environment',
            '_pop_environment',
            '_reset_environment',
        ),
        'LaunchContext: the actions of launch call it, and those of public packages with scopes of their own',
    ),
    '_conditionally_included': 'DeclareLaunchArgument: ros2launch and launch_testing read it',
    '_set_ros_time_is_active': 'ROSClock: rclpy.time_source and the tests of rclpy call it',
    '_set_executor': 'Future: the clients of rclpy and of its actions call it',
    '_TYPE_SUPPORT': 'message classes: rclpy asks their metaclass for it',
    '_chain': 'BufferCore of tf2_py, in C++ upstream: the tests of tf2 call it',
}
"""ROS 2's own names with an underscore that other modules of ROS 2, or packages, use as we do: whose, and who does."""


def private_reaches(path: Path) -> Iterator[tuple[int, str]]:
    """(line, text) of each private attribute that a file reaches for on an object of another file's class.

    What the file itself names, as an attribute of `self`, `cls` or a class or as a function or class, is its own; so is everything
    behind `self` and `cls`, which a class may have from its bases.
    """
    here = nodes(path)
    own = {node.name for node in here if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef))}
    own |= {name.id for node in here if isinstance(node, ast.ClassDef) for name in _targets(node)}
    own |= {node.attr for node in here if isinstance(node, ast.Attribute) and _is_self(node.value)}
    for node in here:
        if isinstance(node, ast.Attribute) and _is_private(node.attr) and node.attr not in own and not _is_self(node.value):
            yield node.lineno, ast.unparse(node)


def _targets(node: ast.ClassDef) -> list[ast.Name]:
    """What the body of a class assigns or declares."""
    targets = [[line.target] if isinstance(line, ast.AnnAssign) else getattr(line, 'targets', []) for line in node.body]
    return [target for each in targets for target in each if isinstance(target, ast.Name)]


def _is_self(node: ast.expr) -> bool:
    return isinstance(node, ast.Name) and node.id in ('self', 'cls')


def _is_private(name: str) -> bool:
    return name.startswith('_') and not name.startswith('__') and name not in {*NAMED_SO_BY_THE_LANGUAGE, *NAMED_SO_BY_ROS}
