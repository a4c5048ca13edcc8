"""Find the endpoints, frames and name of a program's node in its Python files. The reader does not run the program.

The reader evaluates only expressions whose value is certain. They are literals, f-strings, variables that one statement
sets, and parameters with the values from the launch file. The reader reports every other expression as unknown.
"""

from __future__ import annotations

import ast
import os
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, NamedTuple

from edulaunch.advice.run_sources import keyword_of, name_of_call
from edulaunch.advice.texts.bound_names import imported
from edulaunch.ros.sources.source_package import parsed

MAKERS = {
    'create_publisher': ('publisher', 0, 1),
    'create_subscription': ('subscription', 0, 1),
    'create_service': ('service', 0, 1),
    'create_client': ('client', 0, 1),
    'Subscriber': ('subscription', 1, 2),
    'ActionServer': ('service', 1, 2),
    'ActionClient': ('client', 1, 2),
}
"""For each call, the kind of the endpoint, and the positions of the arguments with its type and its name."""
KEYWORDS = {
    'create_publisher': 'topic',
    'create_subscription': 'topic',
    'create_service': 'srv_name',
    'create_client': 'srv_name',
}
TF = 'tf2_msgs/msg/TFMessage'
OF_TF = {
    'TransformBroadcaster': [('publisher', '/tf', TF)],
    'StaticTransformBroadcaster': [('publisher', '/tf_static', TF)],
    'TransformListener': [('subscription', '/tf', TF), ('subscription', '/tf_static', TF)],
}
PASSED_ON = ('get_parameter_value', 'string_value', 'integer_value', 'double_value', 'bool_value', 'value')
UNKNOWN = object()
MOST_STEPS = 20
End = tuple[str, str, str]
"""The kind ('publisher', 'subscription', 'service' or 'client'), the name in the program, and the type."""


class SourceEnds(NamedTuple):
    """The endpoints and frames of a program.

    :ivar name: the name of the program's node, or None if the reader cannot determine it.
    :ivar frames: (parent, child, is static) of each transform.
    :ivar unknown: the expressions that determine an endpoint or a frame and that the reader cannot evaluate.
    """

    name: str | None
    ends: list[End]
    frames: list[tuple[str, str, bool]]
    unknown: list[str]


def read_ends(paths: Sequence[str], parameters: Mapping[str, Any]) -> SourceEnds:
    """Return the endpoints and frames that the Python files of one program define.

    :param paths: the paths of the files.
    :param parameters: the values that the launch file gives to the node's parameters.
    """
    ends: list[End] = []
    frames: list[tuple[str, str, bool]] = []
    names: list[str] = []
    unknown: list[str] = []
    for path in paths:
        tree = parsed(path)
        if tree is not None:
            reader = _Reader(tree, parameters)
            names += reader.node_names()
            for end in reader.ends():
                if isinstance(end, str):
                    unknown.append(end)
                else:
                    ends.append(end)
            for frame in reader.frames():
                if isinstance(frame, str):
                    unknown.append(frame)
                else:
                    frames.append(frame)
    name = names[0] if len(set(names)) == 1 else None
    return SourceEnds(name, list(dict.fromkeys(ends)), list(dict.fromkeys(frames)), list(dict.fromkeys(unknown)))


def read_defaults(paths: Sequence[str]) -> dict[str, Any]:
    """Return the parameters that a program declares with their defaults, if the reader can evaluate the defaults."""
    found: dict[str, Any] = {}
    for tree in map(parsed, paths):
        found |= _Reader(tree, {}).defaults() if tree is not None else {}
    return found


def files_of(path: str) -> list[str]:
    """Return a program's file, and the files in its folder that it imports directly or indirectly."""
    found: list[str] = []
    waiting = [path]
    while waiting:
        here = waiting.pop()
        if here in found:
            continue
        found.append(here)
        tree = parsed(here)
        waiting += _imported_beside(tree, os.path.dirname(here)) if tree is not None else []
    return found


def _imported_beside(tree: ast.Module, folder: str) -> Iterator[str]:
    package = os.path.basename(folder)
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and (node.level == 1 or (node.module or '').split('.')[0] == package):
            module = (node.module or '').removeprefix(package).strip('.').replace('.', os.sep)
            for name in [module] if module else [alias.name for alias in node.names]:
                path = os.path.join(folder, f'{name}.py')
                if os.path.isfile(path):
                    yield path


class _Reader:
    """Reads one Python file."""

    def __init__(self, tree: ast.Module, parameters: Mapping[str, Any]) -> None:
        self._tree = tree
        self._parameters = parameters
        self._imported = imported(tree)
        self._calls = [node for node in ast.walk(tree) if isinstance(node, ast.Call)]
        self._defaults = {
            name: call.args[1] if len(call.args) > 1 else keyword_of(call, 'value')
            for call in self._calls
            if name_of_call(call) == 'declare_parameter' and call.args
            for name in [self.value(call.args[0])]
            if isinstance(name, str)
        }
        self._set: dict[str, list[ast.expr | None]] = {}
        for node in ast.walk(tree):
            if isinstance(node, ast.Assign):
                for target in node.targets:
                    self._note(target, node.value)
            elif isinstance(node, (ast.AnnAssign, ast.AugAssign, ast.For, ast.NamedExpr)):
                self._note(node.target, node.value if isinstance(node, (ast.AnnAssign, ast.NamedExpr)) else None)
            elif isinstance(node, ast.arg):
                self._set.setdefault(node.arg, []).append(None)

    def defaults(self) -> dict[str, Any]:
        """Return the declared parameters whose defaults are certain."""
        values = {name: self.value(default) for name, default in self._defaults.items()}
        return {name: value for name, value in values.items() if value is not UNKNOWN}

    def _note(self, target: ast.expr, value: ast.expr | None) -> None:
        """Store the expression that sets a variable.

        A second assignment makes the variable unknown. So does an assignment to several variables at once.
        """
        parts = target.elts if isinstance(target, (ast.Tuple, ast.List)) else [target]
        for part in parts:
            if isinstance(part, (ast.Name, ast.Attribute)):
                self._set.setdefault(ast.unparse(part), []).append(value if part is target else None)

    def node_names(self) -> Iterator[str]:
        """Yield the names of the nodes that the file creates."""
        for call in self._calls:
            name = name_of_call(call)
            is_super = name == '__init__' and isinstance(call.func, ast.Attribute) and name_of_call(call.func.value) == 'super'
            if is_super or name in ('create_node', 'Node'):
                value = self.value(call.args[0] if call.args else keyword_of(call, 'node_name'))
                if isinstance(value, str):
                    yield value

    def ends(self) -> Iterator[End | str]:
        """Yield each endpoint. If the name of an endpoint is unknown, yield the expression for the name instead."""
        for call in self._calls:
            name = name_of_call(call)
            yield from OF_TF.get(name, ())
            if name in MAKERS:
                kind, of_type, of_name = MAKERS[name]
                written = call.args[of_name] if len(call.args) > of_name else keyword_of(call, KEYWORDS.get(name, 'topic'))
                value = self.value(written)
                if isinstance(value, str):
                    yield kind, value, self._type(call.args[of_type] if len(call.args) > of_type else None)
                elif written is not None and self._is_of_a_node(name):
                    yield f'{kind} (name: {ast.unparse(written)})'

    def _is_of_a_node(self, name: str) -> bool:
        return name.startswith('create_') or self._imported.get(name, '').startswith(('rclpy', 'message_filters'))

    def _type(self, node: ast.expr | None) -> str:
        full = '' if node is None else ast.unparse(node)
        root, dot, rest = full.partition('.')
        parts = (self._imported.get(root, root) + dot + rest).split('.')
        return '/'.join(parts) if len(parts) == 3 and parts[1] in ('msg', 'srv', 'action') else full

    def frames(self) -> Iterator[tuple[str, str, bool] | str]:
        """Yield each transform that the file fills in.

        If the name of a frame is unknown, yield the expression for the name instead.
        """
        makers = {name_of_call(call) for call in self._calls}
        if not makers & {'TransformBroadcaster', 'StaticTransformBroadcaster'}:
            return
        is_static = 'TransformBroadcaster' not in makers
        for key, values in self._set.items():
            if key.endswith('.child_frame_id'):
                parents = self._set.get(key.removesuffix('child_frame_id') + 'header.frame_id', [None])
                for number, child in enumerate(values):
                    pair = child, parents[min(number, len(parents) - 1)]
                    names = [self.value(one) for one in pair]
                    if all(isinstance(name, str) for name in names):
                        yield str(names[1]).lstrip('/'), str(names[0]).lstrip('/'), is_static
                    else:
                        yield 'frame ' + ' in '.join('?' if one is None else ast.unparse(one) for one in pair)

    def value(self, node: ast.expr | None, steps: int = 0) -> Any:
        """Return the value of an expression, or `UNKNOWN` if it is not certain."""
        if node is None or steps > MOST_STEPS:
            return UNKNOWN
        if isinstance(node, ast.Constant):
            return node.value
        if isinstance(node, ast.JoinedStr):
            return _joined([self.value(part, steps + 1) for part in node.values])
        if isinstance(node, ast.FormattedValue):
            return self.value(node.value, steps + 1) if node.format_spec is None and node.conversion in (-1, 115) else UNKNOWN
        if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
            return _joined([self.value(node.left, steps + 1), self.value(node.right, steps + 1)], strict=True)
        if isinstance(node, ast.Call):
            return self._called(node, steps)
        if isinstance(node, ast.Attribute) and node.attr in PASSED_ON:
            return self.value(node.value, steps + 1)
        if isinstance(node, (ast.Name, ast.Attribute)):
            return self._variable(ast.unparse(node), steps)
        return UNKNOWN

    def _variable(self, name: str, steps: int) -> Any:
        values = self._set.get(name, ())
        return self.value(values[0], steps + 1) if len(values) == 1 else UNKNOWN

    def _called(self, call: ast.Call, steps: int) -> Any:
        name = name_of_call(call)
        if name in PASSED_ON and isinstance(call.func, ast.Attribute):
            return self.value(call.func.value, steps + 1)
        if name in ('declare_parameter', 'get_parameter') and call.args:
            parameter = self.value(call.args[0], steps + 1)
            if parameter in self._parameters:
                return self._parameters[parameter]
            return self.value(self._defaults.get(parameter), steps + 1)
        if name == 'str' and len(call.args) == 1:
            return self.value(call.args[0], steps + 1)
        return UNKNOWN


def _joined(parts: list[Any], strict: bool = False) -> Any:
    kinds = (str,) if strict else (str, int, float)
    return ''.join(map(str, parts)) if all(isinstance(part, kinds) for part in parts) else UNKNOWN
