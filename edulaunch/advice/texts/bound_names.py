"""Find the defined and undefined names in a Python file, and the modules from which names are imported."""

from __future__ import annotations

import ast
import builtins
import importlib
from collections.abc import Iterator
from functools import cache
from importlib.util import find_spec
from typing import Any

from edulaunch.advice.errors.launch_files import misspelt
from edulaunch.advice.launch_names import MODULES, names_in
from edulaunch.advice.rule import Failure
from edulaunch.advice.texts.syntax import Foreseen
from edulaunch.advice.texts.text import Span, Text
from edulaunch.engine.nearest import nearest, nearest_spelling

OF_LAUNCH = frozenset(('ament_index_python', 'launch', 'launch_ros', 'launch_xml', 'launch_yaml'))
ALWAYS = frozenset((*dir(builtins), '__file__', '__name__', '__doc__', '__package__', '__spec__', '__loader__', '__builtins__'))


def bound_names(tree: ast.Module) -> set[str] | None:
    """Return all names that a file defines. Return None if `import *`, `exec` or `globals()` may define other names."""
    found: set[str] = set()
    for node in ast.walk(tree):
        if isinstance(node, (ast.Import, ast.ImportFrom)):
            for alias in node.names:
                if alias.name == '*':
                    return None
                found.add(alias.asname or alias.name.partition('.')[0])
        elif isinstance(node, ast.Name):
            if node.id in ('exec', 'globals', 'locals', 'vars', 'setattr'):
                return None
            if not isinstance(node.ctx, ast.Load):
                found.add(node.id)
        elif isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
            found.add(node.name)
        elif isinstance(node, ast.arg):
            found.add(node.arg)
        elif isinstance(node, (ast.ExceptHandler, ast.MatchAs, ast.MatchStar)) and node.name:
            found.add(node.name)
        elif isinstance(node, ast.MatchMapping) and node.rest:
            found.add(node.rest)
        elif isinstance(node, (ast.Global, ast.Nonlocal)):
            found.update(node.names)
    return found


def unknown_names(text: Text, tree: ast.Module, process: str | None = None) -> Iterator[Foreseen]:
    """Yield an error for each undefined name, at its first use.

    :param text: the content of the file.
    :param tree: the syntax tree of the file.
    :param process: the name of the program, or None for a launch file.
    """
    bound = bound_names(tree)
    if bound is None:
        return
    seen: set[str] = set()
    names = [node for node in ast.walk(tree) if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load)]
    for node in sorted(names, key=lambda one: (one.lineno, one.col_offset)):
        if node.id not in bound and node.id not in ALWAYS and node.id not in seen:
            seen.add(node.id)
            message = f"name '{node.id}' is not defined"
            failure = Failure('NameError', message, text.path, node.lineno, process=process, facts={'bound': sorted(bound)})
            yield Foreseen(failure, text.of_node(node))


def imported(tree: ast.Module) -> dict[str, str]:
    """Return the full name of each imported name, such as 'Node' -> 'launch_ros.actions.Node'."""
    found: dict[str, str] = {}
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and node.module and not node.level:
            found.update({alias.asname or alias.name: f'{node.module}.{alias.name}' for alias in node.names})
        elif isinstance(node, ast.Import):
            found.update(
                {
                    alias.asname or alias.name.partition('.')[0]: alias.asname and alias.name or alias.name.partition('.')[0]
                    for alias in node.names
                }
            )
    return found


def full_name(function: ast.expr, names: dict[str, str]) -> str | None:
    """Return the full name of a called function, or None if the file does not import it.

    :param function: the expression before the brackets of the call.
    :param names: the result of :func:`imported`.
    """
    parts: list[str] = []
    while isinstance(function, ast.Attribute):
        parts.insert(0, function.attr)
        function = function.value
    root = names.get(function.id) if isinstance(function, ast.Name) else None
    return None if root is None else '.'.join((root, *parts))


def launch_imports(text: Text, tree: ast.Module) -> Iterator[Foreseen]:
    """Yield an error for each import of a module or name that launch does not have."""
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and node.module and not node.level:
            module = node.module
            if module.partition('.')[0] in OF_LAUNCH or misspelt(module):
                yield from _import_from(text, node, module)
        elif isinstance(node, ast.Import):
            for alias in node.names:
                if (alias.name.partition('.')[0] in OF_LAUNCH or misspelt(alias.name)) and not is_module(alias.name):
                    yield _no_module(text, alias.name, node)


def _import_from(text: Text, node: ast.ImportFrom, module: str) -> Iterator[Foreseen]:
    if not is_module(module):
        yield _no_module(text, module, node)
        return
    for alias in node.names:
        if alias.name != '*' and not has_name(module, alias.name):
            message = f"cannot import name '{alias.name}' from '{module}' (unknown location)"
            yield Foreseen(Failure('ImportError', message, text.path, node.lineno), text.of_node(alias))


def _no_module(text: Text, module: str, node: ast.stmt) -> Foreseen:
    within = text.of_node(node)
    failure = Failure('ModuleNotFoundError', f"No module named '{module}'", text.path, node.lineno)
    return Foreseen(failure, text.found(module, within) or within)


@cache
def is_module(name: str) -> bool:
    """Return whether a module of launch has this name. No file of a student is imported for that."""
    if name in MODULES:
        return True
    if name.partition('.')[0] not in OF_LAUNCH:
        return False
    try:
        return find_spec(name) is not None
    except (ImportError, ValueError):
        return False


@cache
def has_name(module: str, name: str) -> bool:
    """Return whether a module of launch contains a name, or a submodule with that name."""
    if name in names_in(module):
        return True
    try:
        found = importlib.import_module(module)
    except ImportError:
        return True
    return hasattr(found, name) or (hasattr(found, '__path__') and is_module(f'{module}.{name}'))


def interface_imports(text: Text, tree: ast.Module, process: str, registry: Any) -> Iterator[Foreseen]:
    """Yield an error for each import of a message, service or action that its package does not contain."""
    for node in ast.walk(tree):
        if not (isinstance(node, ast.ImportFrom) and node.module and not node.level):
            continue
        package, _, kind = node.module.partition('.')
        if kind in ('msg', 'srv', 'action') and package not in registry.packages():
            near = nearest_spelling(package, registry.packages())
            if near is not None:
                facts = {'about': 'messages.unknown-package', 'module': package, 'near': near}
                failure = Failure(
                    'ModuleNotFoundError', f"No module named '{package}'", text.path, node.lineno, process=process, facts=facts
                )
                yield Foreseen(failure, text.found(package, text.of_node(node)))
        elif kind in ('msg', 'srv', 'action') and registry.has(package, kind):
            known = registry.names(package, kind)
            for alias in node.names:
                if alias.name not in known and alias.name != '*':
                    yield _no_interface(text, node, alias, known, process, registry)


def _no_interface(text: Text, node: ast.ImportFrom, alias: ast.alias, known: list[str], process: str, registry: Any) -> Foreseen:
    facts = {
        'about': 'messages.no-interface',
        'interface': alias.name,
        'module': node.module,
        'homes': registry.homes(alias.name),
        'near': nearest(alias.name, known),
    }
    message = f"cannot import name '{alias.name}' from '{node.module}'"
    return Foreseen(Failure('ImportError', message, text.path, node.lineno, process=process, facts=facts), text.of_node(alias))


def text_of(node: ast.AST | None) -> str | None:
    """Return the value of a string literal. Return None for any other syntax node."""
    return node.value if isinstance(node, ast.Constant) and isinstance(node.value, str) else None


def inside_quotes(text: Text, node: ast.AST) -> Span:
    """Return the span of a string literal without its quotes."""
    span = text.of_node(node)
    return Span(span.start + 1, span.end - 1)
