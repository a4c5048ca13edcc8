"""Where the values of a node's parameters were written, for people."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from launch.substitutions.values import LaunchConfiguration

from ._given_parameters import Given
from ._written_lines import key_lines

if TYPE_CHECKING:
    from edulaunch.graph.parameter_files import Entry
    from edulaunch.processes import Origin


class GlobalParameter(tuple[str, Any]):
    """Name and value from a SetParameter action, with the place of that action.

    Upstream keeps a plain pair, and so it looks.
    """

    origin: Origin | None = None


def place_text(file: str, line: int) -> str:
    """'robot.launch.py line 12'."""
    return f'{os.path.basename(file)} line {line}'


def given_by_global(parameter: tuple[str, Any]) -> list[Given]:
    """By SetParameter."""
    name, value = parameter
    origin = getattr(parameter, 'origin', None)
    if origin is None:
        return [Given('/**', name, value, 'SetParameter')]
    return [Given('/**', name, value, f'SetParameter in {place_text(*origin)}', *origin)]


def given_by_file(path: str, entries_of: Callable[[str], Sequence[Entry]]) -> list[Given]:
    """By a parameter file; nothing when it cannot be read, for then the node says what is wrong."""
    try:
        entries = entries_of(path)
    except (OSError, ValueError):
        return []
    return [Given(one.pattern, one.name, one.value, place_text(path, one.line), path, one.line, True) for one in entries]


def given_by_launch_file(
    pattern: str, values: Mapping[str, Any], written: Mapping[Any, Any], node: Origin | None
) -> Iterator[Given]:
    """By one dict: the origin is the launch argument that decides a value, else the line that names it, else that of the node.

    :param values: evaluated.
    :param written: normalized; in the same order, unless two names came out equal.
    """
    if len(values) != len(written) or node is None:
        origin = 'launch file' if node is None else place_text(*node)
        for name, value in values.items():
            yield Given(pattern, name, value, origin, *(node or ()))
        return
    lines: dict[str, int] | None = None
    for (name, value), text in zip(values.items(), written.values(), strict=True):
        argument = argument_in(text)
        line = getattr(text, 'line', 0)
        if not line:
            lines = key_lines(*node) if lines is None else lines
            line = lines.get(name) or lines.get(name.rpartition('.')[2]) or node.line
        yield Given(pattern, name, value, argument or place_text(node.file, line), node.file, line)


def argument_in(value: Any) -> str | None:
    """'launch argument x', when a launch configuration decides the value."""
    value = getattr(value, 'written', value)
    for part in value if isinstance(value, (list, tuple)) else (value,):
        if isinstance(part, LaunchConfiguration):
            names = [getattr(text, 'text', '') for text in part.variable_name]
            return f'launch argument {"".join(names)}'
        if isinstance(part, (list, tuple)):
            found = argument_in(part)
            if found is not None:
                return found
    return None
