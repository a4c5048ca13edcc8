"""Evaluates Python text without running it, with a small interpreter for assignments, loops and harmless calls.

An unsupported expression becomes an :class:`~edulaunch.ros.sources.static_values.Unknown`. Every expression that contains it also
becomes unknown. So a line of a setup.py that cannot be evaluated affects only its own value.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator
from typing import Any

from edulaunch.ros.sources.static_values import METHODS, PATH_ATTRIBUTES, Module, PathText, Unknown, callables, first_unknown

_STEPS = 20_000

_BINARY: dict[type[ast.operator], Callable[[Any, Any], Any]] = {
    ast.Add: lambda a, b: a + b,
    ast.Mod: lambda a, b: a % b,
    ast.Div: lambda a, b: a / b,
    ast.Mult: lambda a, b: a * b,
    ast.Sub: lambda a, b: a - b,
}
_COMPARE: dict[type[ast.cmpop], Callable[[Any, Any], Any]] = {
    ast.Eq: lambda a, b: a == b,
    ast.NotEq: lambda a, b: a != b,
    ast.In: lambda a, b: a in b,
    ast.NotIn: lambda a, b: a not in b,
    ast.Is: lambda a, b: a is b,
    ast.IsNot: lambda a, b: a is not b,
    ast.Gt: lambda a, b: a > b,
    ast.Lt: lambda a, b: a < b,
}


class _Returned(Exception):
    """Transports the value of a `return` out of an evaluated function."""


class StaticPython:
    """Evaluates one module.

    :param file: the path of the module, which is the value of `__file__`.
    :param folder: the folder at which relative paths start.
    :param watch: dotted names of functions whose calls are stored in :attr:`calls` as (line, keyword values).
    """

    def __init__(self, file: str, folder: str, watch: frozenset[str]) -> None:
        self.names: dict[str, Any] = {'__file__': file, '__name__': '__main__'}
        self.calls: list[tuple[int, dict[str, Any]]] = []
        self._watch = watch
        self._functions = callables(folder)
        self._steps = 0

    def run(self, body: list[ast.stmt]) -> None:
        """Evaluate statements in order."""
        for statement in body:
            self._steps += 1
            if self._steps < _STEPS:
                getattr(self, f'_do_{type(statement).__name__}', self._skip)(statement)

    def value(self, node: ast.expr | None) -> Any:
        """Return the value of an expression, or an Unknown."""
        if node is None:
            return None
        self._steps += 1
        method = getattr(self, f'_of_{type(node).__name__}', None)
        if method is None or self._steps >= _STEPS:
            return self._unknown(node)
        try:
            return method(node)
        except _Returned:
            raise
        except Exception:  # any error of the evaluated program only makes its value unknown
            return self._unknown(node)

    def _unknown(self, node: ast.AST) -> Unknown:
        text = ast.unparse(node)
        return Unknown(getattr(node, 'lineno', 0), text if len(text) <= 60 else text[:57] + '...')

    # statements

    def _skip(self, statement: ast.stmt) -> None:
        """Skip classes, deletions and similar statements, which do not affect what is installed."""

    def _do_Expr(self, node: ast.Expr) -> None:
        self.value(node.value)

    def _do_Import(self, node: ast.Import) -> None:
        for alias in node.names:
            self.names[alias.asname or alias.name.partition('.')[0]] = Module(
                alias.name if alias.asname else alias.name.partition('.')[0]
            )

    def _do_ImportFrom(self, node: ast.ImportFrom) -> None:
        for alias in node.names:
            self.names[alias.asname or alias.name] = Module(f'{node.module}.{alias.name}')

    def _do_Assign(self, node: ast.Assign) -> None:
        value = self.value(node.value)
        for target in node.targets:
            self._bind(target, value)

    def _do_AnnAssign(self, node: ast.AnnAssign) -> None:
        self._bind(node.target, self.value(node.value))

    def _do_AugAssign(self, node: ast.AugAssign) -> None:
        target = ast.copy_location(
            ast.BinOp(left=ast.parse(ast.unparse(node.target), mode='eval').body, op=node.op, right=node.value), node
        )
        self._bind(node.target, self.value(target))

    def _do_If(self, node: ast.If) -> None:
        test = self.value(node.test)
        for body in [node.body, node.orelse] if isinstance(test, Unknown) else [node.body if test else node.orelse]:
            self.run(body)

    def _do_For(self, node: ast.For) -> None:
        items = self.value(node.iter)
        for item in () if isinstance(items, Unknown) else items:
            self._bind(node.target, item)
            self.run(node.body)

    def _do_With(self, node: ast.With) -> None:
        for item in node.items:
            if item.optional_vars is not None:
                self._bind(item.optional_vars, self._unknown(item.context_expr))
        self.run(node.body)

    def _do_Try(self, node: ast.Try) -> None:
        self.run(node.body + node.orelse + node.finalbody)

    def _do_FunctionDef(self, node: ast.FunctionDef) -> None:
        self.names[node.name] = node

    def _do_Return(self, node: ast.Return) -> None:
        raise _Returned(self.value(node.value))

    def _bind(self, target: ast.expr, value: Any) -> None:
        if isinstance(target, ast.Name):
            self.names[target.id] = value
        elif isinstance(target, ast.Tuple | ast.List):
            parts = [value] * len(target.elts) if isinstance(value, Unknown) else list(value)
            for name, part in zip(target.elts, parts, strict=False):
                self._bind(name, part)
        elif isinstance(target, ast.Subscript):
            holder = self.value(target.value)
            if isinstance(holder, dict | list):
                holder[self.value(target.slice)] = value

    # expressions

    def _of_Constant(self, node: ast.Constant) -> Any:
        return node.value

    def _of_Name(self, node: ast.Name) -> Any:
        if node.id in self.names:
            return self.names[node.id]
        return Module(node.id) if node.id in self._functions else self._unknown(node)

    def _of_Attribute(self, node: ast.Attribute) -> Any:
        holder = self.value(node.value)
        if isinstance(holder, PathText) and node.attr in PATH_ATTRIBUTES:
            return getattr(holder, node.attr)
        return Module(f'{holder.name}.{node.attr}') if isinstance(holder, Module) else self._unknown(node)

    def _items(self, nodes: list[ast.expr]) -> list[Any]:
        items: list[Any] = []
        for node in nodes:
            if isinstance(node, ast.Starred):
                inner = self.value(node.value)
                items += [inner] if isinstance(inner, Unknown) else list(inner)
            else:
                items.append(self.value(node))
        return items

    def _of_List(self, node: ast.List) -> Any:
        return self._items(node.elts)

    def _of_Tuple(self, node: ast.Tuple) -> Any:
        return tuple(self._items(node.elts))

    def _of_Set(self, node: ast.Set) -> Any:
        return self._items(node.elts)

    def _of_Dict(self, node: ast.Dict) -> Any:
        result: dict[Any, Any] = {}
        for key, item in zip(node.keys, node.values, strict=False):
            value = self.value(item)
            if key is None:
                result.update(value)
            else:
                result[self.value(key)] = value
        return result

    def _of_JoinedStr(self, node: ast.JoinedStr) -> Any:
        parts = [self.value(part) for part in node.values]
        return first_unknown(parts) or ''.join(map(str, parts))

    def _of_FormattedValue(self, node: ast.FormattedValue) -> Any:
        return self.value(node.value)

    def _of_BinOp(self, node: ast.BinOp) -> Any:
        left, right = self.value(node.left), self.value(node.right)
        if isinstance(node.op, ast.Add) and isinstance(left, list) and isinstance(right, Unknown):
            return [*left, right]
        if isinstance(node.op, ast.Add) and isinstance(right, list) and isinstance(left, Unknown):
            return [left, *right]
        return (
            first_unknown((left, right))
            if isinstance(left, Unknown) or isinstance(right, Unknown)
            else _BINARY[type(node.op)](left, right)
        )

    def _of_BoolOp(self, node: ast.BoolOp) -> Any:
        value: Any = None
        for part in node.values:
            value = self.value(part)
            if isinstance(value, Unknown) or bool(value) is isinstance(node.op, ast.Or):
                return value
        return value

    def _of_UnaryOp(self, node: ast.UnaryOp) -> Any:
        value = self.value(node.operand)
        if isinstance(value, Unknown):
            return value
        return not value if isinstance(node.op, ast.Not) else -value

    def _of_Compare(self, node: ast.Compare) -> Any:
        left, right = self.value(node.left), self.value(node.comparators[0])
        return first_unknown((left, right)) or _COMPARE[type(node.ops[0])](left, right)

    def _of_IfExp(self, node: ast.IfExp) -> Any:
        test = self.value(node.test)
        return test if isinstance(test, Unknown) else self.value(node.body if test else node.orelse)

    def _of_Subscript(self, node: ast.Subscript) -> Any:
        return self.value(node.value)[self.value(node.slice)]

    def _of_Slice(self, node: ast.Slice) -> Any:
        return slice(self.value(node.lower), self.value(node.upper), self.value(node.step))

    def _of_ListComp(self, node: ast.ListComp | ast.GeneratorExp) -> Any:
        return [self.value(node.elt) for _ in self._rounds(node.generators)]

    _of_GeneratorExp = _of_ListComp

    def _of_DictComp(self, node: ast.DictComp) -> Any:
        return {self.value(node.key): self.value(node.value) for _ in self._rounds(node.generators)}

    def _rounds(self, generators: list[ast.comprehension]) -> Iterator[None]:
        if not generators:
            yield None
            return
        first, *rest = generators
        for item in self.value(first.iter):
            self._bind(first.target, item)
            if all(self.value(test) for test in first.ifs):
                yield from self._rounds(rest)

    # calls

    def _of_Lambda(self, node: ast.Lambda) -> Any:
        return node

    def _of_Call(self, node: ast.Call) -> Any:
        keywords = self._keywords(node)
        function = self._method(node.func) or self.value(node.func)
        if isinstance(function, Module) and function.name in self._watch:
            self.calls.append((node.lineno, keywords))
            return None
        arguments = self._items(node.args)
        if isinstance(function, ast.FunctionDef | ast.Lambda):
            return self._call_own(function, arguments, keywords)
        if isinstance(function, Module):
            function = self._functions[function.name]
        adds = isinstance(node.func, ast.Attribute) and node.func.attr in ('append', 'extend', 'insert')
        unknown = first_unknown([arguments, keywords])
        if unknown is not None and not adds:
            return unknown
        if unknown is not None and node.func.attr == 'extend' and isinstance(arguments[0], Unknown):  # type: ignore[attr-defined]
            arguments = [[arguments[0]]]
        return function(*map(self._callable, arguments), **{name: self._callable(value) for name, value in keywords.items()})

    def _keywords(self, node: ast.Call) -> dict[str, Any]:
        keywords: dict[str, Any] = {}
        for keyword in node.keywords:
            value = self.value(keyword.value)
            if keyword.arg is not None:
                keywords[keyword.arg] = value
            elif isinstance(value, dict):
                keywords.update(value)
        return keywords

    def _method(self, node: ast.expr) -> Callable[..., Any] | None:
        """Return the bound method of a plain value, if the evaluation may call it."""
        if not isinstance(node, ast.Attribute):
            return None
        holder = self.value(node.value)
        allowed = METHODS.get(type(holder), frozenset())
        method: Callable[..., Any] | None = getattr(holder, node.attr) if node.attr in allowed else None
        return method

    def _callable(self, value: Any) -> Any:
        """Return a callable for a function that is an argument of another function (`map`, `filter`, `sorted(key=)`)."""
        if isinstance(value, ast.FunctionDef | ast.Lambda):
            return lambda *arguments: self._call_own(value, list(arguments), {})
        return self._functions.get(value.name, value) if isinstance(value, Module) else value

    def _call_own(self, function: ast.FunctionDef | ast.Lambda, arguments: list[Any], keywords: dict[str, Any]) -> Any:
        """Call a function that the file defines: evaluate its body with the arguments bound, and return the result."""
        outer = self.names
        self.names = {**outer, **self._bound(function.args, arguments, keywords)}
        try:
            if isinstance(function, ast.Lambda):
                return self.value(function.body)
            self.run(function.body)
        except _Returned as returned:
            return returned.args[0]
        finally:
            self.names = outer
        return None

    def _bound(self, parameters: ast.arguments, arguments: list[Any], keywords: dict[str, Any]) -> dict[str, Any]:
        """Return the value of each parameter of a function in a call."""
        names = [parameter.arg for parameter in parameters.posonlyargs + parameters.args]
        defaults = zip(reversed(names), map(self.value, reversed(parameters.defaults)), strict=False)
        only = zip((parameter.arg for parameter in parameters.kwonlyargs), map(self.value, parameters.kw_defaults), strict=True)
        bound = {**dict(defaults), **dict(only), **dict(zip(names, arguments, strict=False)), **keywords}
        if parameters.vararg is not None:
            bound[parameters.vararg.arg] = tuple(arguments[len(names) :])
        if parameters.kwarg is not None:
            known = {*names, *(parameter.arg for parameter in parameters.kwonlyargs)}
            bound[parameters.kwarg.arg] = {name: value for name, value in keywords.items() if name not in known}
        return bound
