"""A number that a rubric asks for may be calculated: ``5.544 + 4 * 0.3``."""

from __future__ import annotations

import ast
import operator
from collections.abc import Callable

OPERATORS: dict[type[ast.AST], Callable[[float, float], float]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
}


def calculated(text: str) -> float:
    """The value of numbers with + - * / and brackets between them.

    :raises ValueError: for anything else.
    """
    try:
        return _value(ast.parse(text.strip(), mode='eval').body)
    except (SyntaxError, ZeroDivisionError, RecursionError, KeyError):
        raise ValueError(f'{text!r} is no number, and nothing that is calculated of numbers with + - * / and brackets') from None


def _value(node: ast.expr) -> float:
    if isinstance(node, ast.Constant) and isinstance(node.value, (int, float)) and node.value is not True:
        return float(node.value)
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        return -_value(node.operand)
    if isinstance(node, ast.BinOp):
        return OPERATORS[type(node.op)](_value(node.left), _value(node.right))
    raise KeyError(type(node))
