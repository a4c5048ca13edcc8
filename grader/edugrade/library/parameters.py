"""Values of parameters, and where they came from."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from ..evidence import Evidence, Mismatch, Missing
from ..source import Place
from .launched import find_processes, node_names

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording
    from edulaunch.engine.recording.records import Parameter


def find_parameter(recording: Recording, package: str, executable: str, name: str) -> Parameter | None:
    """A parameter of the nodes of an executable: of the first node that has it."""
    for node in node_names(recording, find_processes(recording, package, executable)):
        parameter = recording.parameters(node).get(name)
        if parameter is not None:
            return parameter
    return None


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
    found = {scenario: find_parameter(run[scenario], package, executable, name) for scenario in wanted}
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
