"""Converts parameters to message-like objects, for nodes that are loaded into a container."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from launch._engine import assumptions, inside

from edulaunch.engine.facts import with_facts

from ..parameter_descriptions import Parameter as ParameterDescription
from ..parameters_type import EvaluatedParameters

if TYPE_CHECKING:
    from pathlib import Path

    from launch.launch_context import LaunchContext
    from rclpy.parameter import Parameter

_KEY = 'ros__parameters'


def to_parameters_list(
    context: LaunchContext, node_name: str, namespace: str, evaluated_parameters: EvaluatedParameters
) -> list[Parameter]:
    """Return one `rclpy.parameter.Parameter` for each evaluated value, in order.

    Files are read according to launch_ros's own rules.
    The patterns `/**` and `**` come first, and then the exact name. A file without
    `ros__parameters` is read as a plain mapping.

    :raises AttributeError: for an empty file, with upstream's message.
    """
    from rclpy.parameter import Parameter

    found: list[Parameter] = []
    for item in evaluated_parameters:
        if isinstance(item, ParameterDescription):
            name, value = item.evaluate(context)
            values: dict[str, Any] = {name: value}
        elif isinstance(item, dict):
            values = item
        else:
            values = _from_file(item, node_name, namespace)
        found += [Parameter(name, value=list(value) if isinstance(value, tuple) else value) for name, value in values.items()]
    return found


def _from_file(path: Path, node_name: str, namespace: str) -> dict[str, Any]:
    from launch.utilities.yaml_reader import read

    assumed = assumptions()
    if assumed is not None and assumed.lacks_file(str(path)):
        return {}
    with open(inside(path), encoding='utf-8') as file:
        content = read(file.read())
    if content is None:
        error = AttributeError("'NoneType' object has no attribute 'items'")
        raise with_facts(error, 'launch.empty-parameter-file', parameter_file=str(path))
    if not _has_parameters(content):
        return _flat(content)
    full_name = f'{namespace.rstrip("/")}/{node_name}' if namespace else f'/{node_name}'
    values: dict[str, Any] = {}
    for pattern in ('/**', '**', full_name):
        values.update(_flat(_section(content, pattern)))
    return values


def _has_parameters(content: Any) -> bool:
    return isinstance(content, dict) and (_KEY in content or any(_has_parameters(value) for value in content.values()))


def _section(content: dict[str, Any], pattern: str) -> dict[str, Any]:
    """Return the entries below `ros__parameters` of a node name, which is one key or several nested keys."""
    for key, value in content.items():
        rest = pattern.lstrip('/')
        name = str(key).strip('/')
        if not isinstance(value, dict):
            continue
        if name == rest and _KEY in value:
            return dict(value[_KEY] or {})
        if rest.startswith(name + '/'):
            found = _section(value, rest[len(name) + 1 :])
            if found:
                return found
    return {}


def _flat(values: dict[str, Any], prefix: str = '') -> dict[str, Any]:
    flat: dict[str, Any] = {}
    for name, value in values.items():
        flat.update(_flat(value, f'{prefix}{name}.') if isinstance(value, dict) else {f'{prefix}{name}': value})
    return flat
