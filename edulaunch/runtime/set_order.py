"""Finds the lines of a program that use the order of a set, which differs from run to run without a fixed hash seed."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import lru_cache

SETS = frozenset({'set', 'frozenset'})
IN_ORDER = frozenset({'enumerate', 'iter', 'list', 'map', 'next', 'print', 'repr', 'str', 'tuple', 'zip'})
"""Functions whose result depends on the order of their arguments."""
_SAME_IN_ANY_ORDER = frozenset({'all', 'any', 'len', 'max', 'min', 'sorted', 'sum', *SETS})


@lru_cache(maxsize=64)
def set_lines(source: bytes) -> tuple[int, ...]:
    """Return the lines on which a loop, a function such as `print`, or an f-string uses the order of a set.

    A name counts as a set if every assignment to it in the file creates a set. A set that contains only numbers does not count.
    """
    nodes = list(ast.walk(ast.parse(source)))
    names = _names_of_sets(nodes)
    unordered = {
        id(argument)
        for node in nodes
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in _SAME_IN_ANY_ORDER
        for argument in node.args
    }
    used = (used for node in nodes if id(node) not in unordered for used in _used_in_order(node))
    return tuple(sorted({node.lineno for node in used if _is_set(node, names)}))


def _names_of_sets(nodes: list[ast.AST]) -> set[str]:
    makes: dict[str, bool] = {}
    for node in nodes:
        targets = node.targets if isinstance(node, ast.Assign) else [node.target] if isinstance(node, ast.AnnAssign) else []
        for target in targets:
            if isinstance(node, (ast.Assign, ast.AnnAssign)) and node.value is not None:
                name = ast.unparse(target)
                makes[name] = makes.get(name, True) and _is_set(node.value, set())
    return {name for name, is_set in makes.items() if is_set}


def _is_set(node: ast.expr, names: set[str]) -> bool:
    if isinstance(node, ast.Set):
        return not all(isinstance(item, ast.Constant) and isinstance(item.value, (int, float)) for item in node.elts)
    if isinstance(node, ast.BinOp):
        return isinstance(node.op, (ast.BitOr, ast.BitAnd, ast.Sub, ast.BitXor)) and _is_set(node.left, names)
    if isinstance(node, ast.Call):
        return isinstance(node.func, ast.Name) and node.func.id in SETS
    return isinstance(node, ast.SetComp) or (isinstance(node, (ast.Name, ast.Attribute)) and ast.unparse(node) in names)


def _used_in_order(node: ast.AST) -> Iterator[ast.expr]:
    if isinstance(node, ast.For):
        yield node.iter
    elif isinstance(node, (ast.ListComp, ast.GeneratorExp, ast.DictComp)):
        yield from (part.iter for part in node.generators)
    elif isinstance(node, (ast.FormattedValue, ast.Starred)):
        yield node.value
    elif isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in IN_ORDER:
        yield from node.args
    elif isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
        if node.func.attr == 'join':
            yield from node.args
        elif node.func.attr == 'pop' and not node.args:
            yield node.func.value
