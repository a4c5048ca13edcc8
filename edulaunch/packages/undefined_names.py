"""Names that a script uses and nobody has defined: it ends there with a NameError, whatever else it says."""

from __future__ import annotations

import ast
import builtins
from collections.abc import Iterator, Sequence

_UNCERTAIN = frozenset(('exec', 'eval', 'globals', 'locals', 'vars', '__import__'))
"""With one of these a script may define names that do not stand in it."""
_GIVEN = frozenset((*dir(builtins), '__file__', '__name__', '__doc__', '__builtins__', '__spec__', '__loader__', '__package__'))


def first_undefined_name(tree: ast.Module) -> tuple[str, int] | None:
    """The first such name and its line; None when there is none, or when that cannot be told.

    Only what is evaluated in any case is looked at: no bodies of functions, conditions, loops and `try`.
    """
    bound = set(_bound(tree))
    used = [node for statement in tree.body for node in _evaluated(statement)]
    if '*' in bound or any(node.id in _UNCERTAIN for node in used):
        return None
    return next(((node.id, node.lineno) for node in used if node.id not in bound and node.id not in _GIVEN), None)


def _bound(tree: ast.Module) -> Iterator[str]:
    """Every name that is bound anywhere in the file, at whatever depth."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            yield node.id
        elif isinstance(node, ast.alias):
            yield node.asname or node.name.partition('.')[0]
        elif isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
            yield node.name
        elif isinstance(node, ast.arg):
            yield node.arg
        elif isinstance(node, (ast.Global, ast.Nonlocal)):
            yield from node.names
        elif isinstance(node, ast.ExceptHandler) and node.name or isinstance(node, (ast.MatchAs, ast.MatchStar)) and node.name:
            yield node.name


def _evaluated(node: ast.AST) -> Iterator[ast.Name]:
    """The names that are read whenever a statement or an expression is reached, in order of evaluation."""
    if isinstance(node, ast.Name):
        yield from [node] if isinstance(node.ctx, ast.Load) else ()
    for child in _surely(node):
        yield from _evaluated(child)


def _surely(node: ast.AST) -> Sequence[ast.AST]:
    """Those parts of a node that are evaluated in any case."""
    if isinstance(node, (ast.If, ast.While, ast.IfExp)):
        return [node.test]
    if isinstance(node, (ast.For, ast.comprehension)):
        return [node.iter]
    if isinstance(node, ast.BoolOp):
        return node.values[:1]
    if isinstance(node, (ast.ListComp, ast.SetComp, ast.GeneratorExp, ast.DictComp)):
        return [node.generators[0]]
    if isinstance(node, (ast.Assign, ast.AugAssign, ast.AnnAssign, ast.NamedExpr)):
        return [] if node.value is None else [node.value]
    plain = (ast.Expr, ast.expr, ast.keyword)
    return list(ast.iter_child_nodes(node)) if isinstance(node, plain) and not isinstance(node, ast.Lambda) else []
