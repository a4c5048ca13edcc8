"""Where the values of a node's parameters were written, for people."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from launch.substitutions.launch_configuration import LaunchConfiguration

from ._written_lines import key_lines

if TYPE_CHECKING:
    from edulaunch.processes import Origin


class GlobalParameter(tuple[str, Any]):
    """Name and value from a SetParameter action, with the place of that action.

    Upstream keeps a plain pair, and so it looks.
    """

    origin: Origin | None = None


def place_text(file: str, line: int) -> str:
    """'robot.launch.py line 12'."""
    return f'{os.path.basename(file)} line {line}'


def origin_of_global(parameter: tuple[str, Any]) -> str:
    """Of a value that SetParameter gave."""
    origin = getattr(parameter, 'origin', None)
    return 'SetParameter' if origin is None else f'SetParameter in {place_text(*origin)}'


def origins_of(values: Mapping[str, Any], written: Mapping[Any, Any], node: Origin | None) -> dict[str, str]:
    """Of the values of one dict: the launch argument that decides it, else the line that names it, else that
    of the node.

    :param values: evaluated.
    :param written: normalized; in the same order, unless two names came out equal.
    """
    if len(values) != len(written) or node is None:
        return dict.fromkeys(values, 'launch file' if node is None else place_text(*node))
    lines: dict[str, int] | None = None
    origins: dict[str, str] = {}
    for name, value in zip(values, written.values(), strict=True):
        argument = _argument_in(value)
        line = getattr(value, 'line', 0)
        if argument is None and not line:
            lines = key_lines(*node) if lines is None else lines
            line = lines.get(name) or lines.get(name.rpartition('.')[2]) or node.line
        origins[name] = argument or place_text(node.file, line)
    return origins


def _argument_in(value: Any) -> str | None:
    """'launch argument x', when a launch configuration decides the value."""
    value = getattr(value, 'written', value)
    for part in value if isinstance(value, (list, tuple)) else (value,):
        if isinstance(part, LaunchConfiguration):
            names = [getattr(text, 'text', '') for text in part.variable_name]
            return f'launch argument {"".join(names)}'
        if isinstance(part, (list, tuple)):
            found = _argument_in(part)
            if found is not None:
                return found
    return None
