"""An import inside a function defers a module. What is loaded together with the file anyway is imported at its top."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import cache

from tests.house import ROOT, modules, tree

FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda)


def at_once(node: ast.AST) -> Iterator[ast.stmt]:
    """Statements that run when the module of a node is imported."""
    for child in ast.iter_child_nodes(node):
        if isinstance(child, FUNCTIONS) or (isinstance(child, ast.If) and ast.unparse(child.test).endswith('TYPE_CHECKING')):
            continue
        if isinstance(child, ast.stmt):
            yield child
        yield from at_once(child)


def named(module: str, node: ast.stmt) -> list[tuple[str, list[str]]]:
    """(module, names taken from it) of an import; nothing for another statement."""
    if isinstance(node, ast.Import):
        return [(alias.name, []) for alias in node.names]
    if not isinstance(node, ast.ImportFrom):
        return []
    package = module if modules()[module].name == '__init__.py' else module.rpartition('.')[0]
    parts = package.split('.')[: len(package.split('.')) - node.level + 1] if node.level else []
    return [('.'.join([*parts, *([node.module] if node.module else [])]), [alias.name for alias in node.names])]


@cache
def loads(module: str) -> frozenset[str]:
    """Modules of the house that the import of a module loads directly: their packages, and what they name."""
    found = {module, *(name for node in at_once(tree(modules()[module])) for name in _with_names(module, node))}
    parents = {name[:end] for name in found for end, letter in enumerate(name) if letter == '.'}
    return frozenset(name for name in found | parents if name in modules() and name != module)


def _with_names(module: str, node: ast.stmt) -> Iterator[str]:
    for source, names in named(module, node):
        yield from (source, *(f'{source}.{name}' for name in names))


@cache
def loaded_with(module: str) -> frozenset[str]:
    """Modules of the house that are loaded when the import of a module has ended."""
    found: set[str] = set()
    ahead = [module]
    while ahead:
        ahead += (new := loads(ahead.pop()) - found)
        found |= new
    return frozenset(found)


@cache
def defined(module: str) -> frozenset[str]:
    """Names that a module has without a late `__getattr__`."""
    names: set[str] = set()
    for node in at_once(tree(modules()[module])):
        if isinstance(node, (ast.Import, ast.ImportFrom)):
            names |= {(alias.asname or alias.name).partition('.')[0] for alias in node.names}
        elif isinstance(node, (ast.Assign, ast.AnnAssign)):
            names |= {name.id for name in ast.walk(node) if isinstance(name, ast.Name) and isinstance(name.ctx, ast.Store)}
        elif isinstance(node, ast.ClassDef):
            names.add(node.name)
    return frozenset(names | {node.name for node in tree(modules()[module]).body if isinstance(node, FUNCTIONS[:2])})


def late(node: ast.AST, is_inside: bool = False) -> Iterator[ast.stmt]:
    """Imports inside functions."""
    for child in ast.iter_child_nodes(node):
        if is_inside and isinstance(child, (ast.Import, ast.ImportFrom)):
            yield child
        elif not isinstance(child, ast.expr):
            yield from late(child, is_inside or isinstance(child, FUNCTIONS))


def is_loaded_anyway(module: str, node: ast.stmt) -> bool:
    """Whether an import inside a function loads nothing that the file does not load already."""
    known = loaded_with(module)
    return all(
        source in known and all(name in defined(source) or f'{source}.{name}' in known for name in names)
        for source, names in named(module, node)
    )


def test_an_import_inside_a_function_defers_a_module() -> None:
    found = [
        f'{path.relative_to(ROOT)}:{node.lineno}: {ast.unparse(node)}'
        for module, path in modules().items()
        for node in late(tree(path))
        if is_loaded_anyway(module, node)
    ]
    assert found == [], 'these modules are loaded with the file anyway: import them at its top'


def test_what_is_loaded_is_seen() -> None:
    assert 'edulaunch.errors' in loaded_with('edulaunch.runtime.session')
    assert 'edulaunch.desk.cli.main' not in loaded_with('edulaunch')
    assert len([node for module in modules() for node in late(tree(modules()[module]))]) > 500
