"""Describes the places that set the values of a node's parameters."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

from launch.substitutions.launch_configuration import LaunchConfiguration

from edulaunch.engine.graph.parameters import pattern_matches, precedence

if TYPE_CHECKING:
    from edulaunch.engine.graph.parameter_files import Entry
    from edulaunch.engine.processes import Origin

# A string (with the colon after it if it is a key), a comment or a bracket. The character before a quote is not checked.
_TOKEN = re.compile(
    r"""(?P<text>"{3}(?:\\.|(?!"{3}).)*"{3}|\'{3}(?:\\.|(?!\'{3}).)*\'{3}|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\')"""  # noqa: Q001
    r"""(?P<colon>\s*:)?|\#[^\n]*|(?P<open>[(\[{])|(?P<close>[)\]}])""",
    re.DOTALL,
)
LONGEST_CALL = 400
"""The maximum number of lines that are read from the beginning of a call."""
SHORT_CALL = 12
"""The number of lines in which nearly all calls end. Reading more lines for each call takes longer than launching it."""


def key_lines(file: str, line: int) -> dict[str, int]:
    """Return the source text of each dictionary key in the call that begins on `line`, with the line of the key.

    For a repeated key, the line of the last occurrence is returned. The result is empty if the file cannot be read.
    """
    import linecache

    lines = linecache.getlines(file)[line - 1 : line - 1 + LONGEST_CALL]
    beginning = ''.join(lines[:SHORT_CALL])
    if len(lines) > SHORT_CALL and '"""' not in beginning and "'''" not in beginning:
        found, is_closed = _keys_in(beginning, line)
        if is_closed:
            return found
    return _keys_in(''.join(lines), line)[0]


def _keys_in(text: str, line: int) -> tuple[dict[str, int], bool]:
    """Return the keys, and whether the call ends within the text, which begins on `line`."""
    found: dict[str, int] = {}
    depth = 0
    counted, number = 0, line
    for token in _TOKEN.finditer(text):
        kind = token.lastgroup
        if kind == 'open':
            depth += 1
        elif kind == 'close':
            depth -= 1
            if depth <= 0:
                return found, True
        elif kind == 'colon' and depth:
            number += text.count('\n', counted, token.start())
            counted = token.start()
            found[token['text'].strip('"\'')] = number
    return found, False


class Given(NamedTuple):
    """One value for one parameter.

    :ivar pattern: the pattern for the names of the nodes that receive the value.
    :ivar origin: a description of the place that sets the value.
    :ivar file: the file of that place, or '' if it is unknown.
    :ivar line: the line of that place, or 0 if it is unknown.
    :ivar is_of_a_file: whether a parameter file sets the value, rather than the launch file.
    """

    pattern: str
    name: str
    value: Any
    origin: str
    file: str = ''
    line: int = 0
    is_of_a_file: bool = False


def in_force(given: Sequence[Given], full_name: str) -> list[Given]:
    """Return the entries for the node `full_name` in rcl's order. The last entry for a parameter counts.

    All entries for one pattern move to the first place of that pattern.
    """
    ranks: dict[str, int] = {}
    for one in given:
        ranks.setdefault(one.pattern, len(ranks))
    meant = {pattern for pattern in ranks if pattern_matches(pattern, full_name)}
    return sorted((one for one in given if one.pattern in meant), key=lambda one: (ranks[one.pattern], -precedence(one.value)))


class ParameterOrigins(Mapping[str, str]):
    """Maps each parameter to the origin of its value, if no parameter file sets the value. The mapping is computed on request.

    :param in_force: a function that returns all given values, in the order of :func:`in_force`.
    """

    def __init__(self, in_force: Callable[[], Sequence[Given]]) -> None:
        self._in_force = in_force

    @cached_property
    def _found(self) -> dict[str, str]:
        winners = {one.name: one for one in self._in_force()}
        return {name: one.origin for name, one in winners.items() if not one.is_of_a_file}

    def __getitem__(self, name: str) -> str:
        return self._found[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._found)

    def __len__(self) -> int:
        return len(self._found)


class GlobalParameter(tuple[str, Any]):
    """The name and the value of a SetParameter action, with the place of that action.

    Upstream stores a plain pair, so this class is a subclass of tuple.
    """

    origin: Origin | None = None


def place_text(file: str, line: int) -> str:
    """Return the place in a form such as 'robot.launch.py line 12'."""
    return f'{os.path.basename(file)} line {line}'


def given_by_global(parameter: tuple[str, Any]) -> list[Given]:
    """Return the value that a SetParameter action gives."""
    name, value = parameter
    origin = getattr(parameter, 'origin', None)
    if origin is None:
        return [Given('/**', name, value, 'SetParameter')]
    return [Given('/**', name, value, f'SetParameter in {place_text(*origin)}', *origin)]


def given_by_file(path: str, entries_of: Callable[[str], Sequence[Entry]]) -> list[Given]:
    """Return the values of a parameter file. If the file cannot be read, return an empty list, because the node reports the
    problem.
    """
    try:
        entries = entries_of(path)
    except (OSError, ValueError):
        return []
    return [Given(one.pattern, one.name, one.value, place_text(path, one.line), path, one.line, True) for one in entries]


def given_by_launch_file(
    pattern: str, values: Mapping[str, Any], written: Mapping[Any, Any], node: Origin | None
) -> Iterator[Given]:
    """Yield the values of one dict, each with its origin.

    The origin is the launch argument that determines the value. Without one, it is the line of the name, or else the line of the
    node.

    :param values: the evaluated values.
    :param written: the normalized values, in the same order unless two evaluated names are equal.
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
    """Return a string such as 'launch argument x' if a launch configuration determines the value. Otherwise, return None."""
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
