"""Predict errors in the programs of nodes: names without an import, missing interfaces, and fields that a message does not
have.
"""

from __future__ import annotations

import ast
import os
from collections.abc import Iterator
from typing import Any

from edulaunch.advice.rule import Failure
from edulaunch.advice.texts.around import Around
from edulaunch.advice.texts.bound_names import imported, interface_imports, unknown_names
from edulaunch.advice.texts.syntax import Foreseen
from edulaunch.advice.texts.text import Span, Text
from edulaunch.engine.nearest import nearest


def foreseen_in_program(text: Text, tree: ast.Module, around: Around) -> Iterator[Foreseen]:
    """Yield the errors that would end the program, in any order."""
    process = os.path.basename(text.path).removesuffix('.py')
    registry = around.registry
    yield from unknown_names(text, tree, process)
    yield from interface_imports(text, tree, process, registry)
    yield from _fields(text, tree, process, registry)


def _fields(text: Text, tree: ast.Module, process: str, registry: Any) -> Iterator[Foreseen]:
    """Yield an error for each unknown field, such as `message.liner` after `message = Twist()`.

    Check only variables that always contain messages of one class in their function.
    """
    names = imported(tree)
    for function in (node for node in ast.walk(tree) if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef))):
        kinds = _messages(function, names, registry)
        for node in ast.walk(function):
            if isinstance(node, ast.Attribute):
                yield from _field(text, node, kinds, process, registry)


def _messages(function: ast.AST, names: dict[str, str], registry: Any) -> dict[str, Any]:
    """Return the variables that always contain a new message of the same class, with this class."""
    made: dict[str, list[Any]] = {}
    for node in ast.walk(function):
        if isinstance(node, ast.Assign):
            for target in node.targets:
                for name in (one.id for one in ast.walk(target) if isinstance(one, ast.Name) and isinstance(one.ctx, ast.Store)):
                    made.setdefault(name, []).append(
                        _class_of(node.value, names, registry) if isinstance(target, ast.Name) else None
                    )
        elif isinstance(node, ast.Name) and not isinstance(node.ctx, ast.Load):
            made.setdefault(node.id, [])
        elif isinstance(node, ast.arg):
            made.setdefault(node.arg, []).append(None)
    stored = [node.id for node in ast.walk(function) if isinstance(node, ast.Name) and not isinstance(node.ctx, ast.Load)]
    return {name: kinds[0] for name, kinds in made.items() if len(kinds) == 1 == stored.count(name) and kinds[0] is not None}


def _class_of(value: ast.expr, names: dict[str, str], registry: Any) -> Any:
    if not (isinstance(value, ast.Call) and isinstance(value.func, ast.Name)):
        return None
    package, _, rest = names.get(value.func.id, '').partition('.')
    kind, _, name = rest.partition('.')
    if kind != 'msg' or not registry.has(package, 'msg') or name not in registry.names(package, 'msg'):
        return None
    return registry.get(f'{package}/msg/{name}')


def _field(text: Text, node: ast.Attribute, kinds: dict[str, Any], process: str, registry: Any) -> Iterator[Foreseen]:
    path = [node.attr]
    inner: ast.expr = node.value
    while isinstance(inner, ast.Attribute):
        path.insert(0, inner.attr)
        inner = inner.value
    cls = kinds.get(inner.id) if isinstance(inner, ast.Name) else None
    if cls is None:
        return
    for number, field in enumerate(path):
        fields = cls.get_fields_and_field_types()
        if field not in fields:
            if number == len(path) - 1 and not hasattr(cls, field) and not field.startswith('_'):
                yield _no_field(text, node, cls, field, list(fields), process)
            return
        package, sign, name = fields[field].partition('/')
        if not sign or '[' in name or '<' in package or name not in registry.names(package, 'msg'):
            return
        cls = registry.get(f'{package}/msg/{name}')


def _no_field(text: Text, node: ast.Attribute, cls: Any, field: str, fields: list[str], process: str) -> Foreseen:
    facts = {'about': 'messages.field', 'type': cls.__name__, 'field': field, 'fields': fields, 'near': nearest(field, fields)}
    message = f"'{cls.__name__}' object has no attribute '{field}'"
    end = text.of_node(node).end
    failure = Failure('AttributeError', message, text.path, node.end_lineno, process=process, facts=facts)
    return Foreseen(failure, Span(end - len(field) - 1, end))
