"""Values of parameters, and where they came from."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from edulaunch.engine.recording.records import Parameter

from ..evidence import Evidence, Mismatch, Missing
from ..source import Place
from .identity import nodes_of
from .launched import find_processes

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording


def parameter_of(recording: Recording, position: int, name: str, wanted: Any = None) -> Parameter | None:
    """Return a parameter of a node as the node read it at its start.

    A value that somebody sets later does not change what the node did with the first one. Where the first one is `wanted` and the
    last one is not, the last one is returned: the node must keep the value.

    :param position: of the node in `recording.nodes`.
    """
    changes = _changes(recording, position, name)
    if not changes:
        return None
    first, last = (Parameter(*change[1:]) for change in (changes[0], changes[-1]))
    if first.value is None or first.value == last.value:
        return first if first.value is not None else None
    if first.value == wanted:
        return last._replace(origin=f'{last.origin}, set at {changes[-1][0]:.2f} s')
    return first._replace(origin=f'{first.origin}, until {changes[1][0]:.2f} s')


def _changes(recording: Recording, position: int, name: str) -> list[tuple[float, Any, str]]:
    """Return every value that a parameter of a node had: (time in s, value or None when undeclared, origin)."""
    node, owners = recording.nodes[position].name, recording.owners
    return [
        (time_ns / 1e9, value, origin)
        for row, (time_ns, of, parameter, value, origin) in enumerate(recording.parameter_rows)
        if (of, parameter) == (node, name) and (owners is None or owners['parameters'][row] == owners['nodes'][position])
    ]


def find_parameter(recording: Recording, package: str, executable: str, name: str, wanted: Any = None) -> Parameter | None:
    """Return a parameter of the nodes of an executable, of the first node that has it; see :func:`parameter_of`."""
    for position in nodes_of(recording, package, executable):
        parameter = parameter_of(recording, position, name, wanted)
        if parameter is not None:
            return parameter
    return None


def node_parameter(recording: Recording, node: str, package: str, name: str, wanted: Any = None) -> Parameter | None:
    """Return a parameter of the node with a fully qualified name, whose program is of a package; see :func:`parameter_of`."""
    positions = [position for position in nodes_of(recording, package) if recording.nodes[position].name == node]
    return parameter_of(recording, positions[0], name, wanted) if positions else None


def with_origin(parameter: Parameter | None) -> str:
    """In words: the value and where it came from."""
    return 'no such parameter' if parameter is None else f'{parameter.value} (from: {parameter.origin})'


def require_parameter(
    run: Evidence, package: str, executable: str, name: str, wanted: Mapping[str, Any], try_: str, where: Place | None = None
) -> None:
    """In each run, a parameter of an executable's node has its value.

    :param wanted: the value for each run, by the scenario's name.
    :param where: what to point at; default: the Node.
    :raises Missing: when the launch file gives the node no parameter of this name, but others.
    :raises Mismatch: with the values seen and their origin.
    """
    found = {key: find_parameter(run[key], package, executable, name, value) for key, value in wanted.items()}
    if all(seen is not None and seen.value == wanted[scenario] for scenario, seen in found.items()):
        return
    process = find_processes(run.first, package, executable)[0]
    given = process.parameter_origins
    where = where or run.source.own(process.origin, 'IncludeLaunchDescription[(]')
    if given and name not in given:
        raise Missing(f'the parameter {name} of the Node', name=name, among=given, try_=try_, where=where)
    raise Mismatch(
        f'the parameter {name} of {executable}',
        _by_run(run, {key: str(value) for key, value in wanted.items()}),
        _by_run(run, {key: with_origin(seen) for key, seen in found.items()}),
        where=where,
        try_=try_,
    )


def _by_run(run: Evidence, texts: Mapping[str, str]) -> str:
    """One text when all runs agree, else a text for each run with its arguments."""
    if len(set(texts.values())) == 1:
        return next(iter(texts.values()))
    return '\n'.join(f'{text} with {run.scenario(name).words}' for name, text in texts.items())
