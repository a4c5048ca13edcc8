"""Checks of parameters: their values, and the origins of the values."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

from edulaunch.engine.recording.records import Parameter

from ..evidence import Advice, Evidence, Failure, Mismatch, Missing, described_defaults, written_text
from ..source import Place
from .identity import nodes_of, processes_of
from .launched import find_processes

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording


def parameter_of(recording: Recording, position: int, name: str, wanted: Any = None) -> Parameter | None:
    """Return a parameter of a node, with the value that the node read when it started. Return None if the node does not have
    the parameter.

    A later value does not change the effect of the first value. But if the first value is `wanted` and the last value is
    not, return the last value, because the node must keep the value.

    :param position: the position of the node in `recording.nodes`.
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
    """Return every value of a parameter as (time in s, value, origin). The value None means undeclared."""
    node, owners = recording.nodes[position].name, recording.owners
    return [
        (time_ns / 1e9, value, origin)
        for row, (time_ns, of, parameter, value, origin) in enumerate(recording.parameter_rows)
        if (of, parameter) == (node, name) and (owners is None or owners['parameters'][row] == owners['nodes'][position])
    ]


def find_parameter(recording: Recording, package: str, executable: str, name: str, wanted: Any = None) -> Parameter | None:
    """Return a parameter of the nodes of an executable, or None; see :func:`parameter_of`.

    If several nodes have it, return the first one whose value is not `wanted`: a right node must not hide a wrong one.
    """
    every = (parameter_of(recording, position, name, wanted) for position in nodes_of(recording, package, executable))
    known = [parameter for parameter in every if parameter is not None]
    return next((each for each in known if each.value != wanted), known[0] if known else None)


def node_parameter(recording: Recording, node: str, package: str, name: str, wanted: Any = None) -> Parameter | None:
    """Return a parameter of a node whose program is in a package, or None; see :func:`parameter_of`.

    :param node: the fully qualified name of the node.
    """
    positions = [position for position in nodes_of(recording, package) if recording.nodes[position].name == node]
    return parameter_of(recording, positions[0], name, wanted) if positions else None


def named_origin(run: Evidence, parameter: Parameter, node: str, name: str) -> str:
    """Return the origin of a parameter. If it is a parameter file, the package must contain this file with this value.

    Without this rule, a launch file could write a file with the same name during the run.
    """
    file = parameter.origin.split(' ')[0]
    texts = run.source.texts()
    if not file.endswith(('.yaml', '.yml')) or len(texts) == 1:
        return parameter.origin
    known = [text for path, text in texts.items() if os.path.basename(path) == file]
    if any(_gives(text, node, name, parameter.value) for text in known):
        return parameter.origin
    return 'a file that is not in the package'


def _gives(text: str, node: str, name: str, value: Any) -> bool:
    """Return whether the content of a parameter file gives a node this value."""
    from edulaunch.engine.graph.parameter_files import ParameterFileError, read_parameter_file
    from edulaunch.engine.graph.parameters import pattern_matches

    try:
        entries = read_parameter_file(text)
    except ParameterFileError:
        return False
    return any(entry.name == name and entry.value == value and pattern_matches(entry.pattern, node) for entry in entries)


def value_and_origin(parameter: Parameter | None) -> str:
    """Return the value and its origin in words for a sentence."""
    if parameter is None:
        return 'no such parameter'
    if parameter.origin == 'default':
        return f'{parameter.value}, the default value'
    return f'{parameter.value}, from {parameter.origin}'


def require_parameter(
    run: Evidence,
    package: str,
    executable: str,
    name: str,
    wanted: Mapping[str, Any],
    try_: Advice,
    where: Place | None = None,
    code: str = '',
) -> None:
    """Require the value of a parameter of an executable's node in each run.

    :param wanted: the expected value for each run, by the scenario's name.
    :param try_: how to pass a value, for a launch file that passes none.
    :param where: the place for the report (default: the place of the Node).
    :param code: the code of the expected value (default: the value itself).
    :raises Missing: if the launch file gives the node other parameters, but not this one.
    :raises Mismatch: with the values and their origins.
    :raises MissingParameterFile: if a parameter file of the node does not exist.
    """
    found = {key: find_parameter(run[key], package, executable, name, value) for key, value in wanted.items()}
    if all(seen is not None and seen.value == wanted[scenario] for scenario, seen in found.items()):
        return
    refuse_missing_file(run, (parameter for parameter in found.values()), package, executable)
    process = find_processes(run.first, package, executable)[0]
    given = process.parameter_origins
    where = where or run.source.own(process.origin, 'IncludeLaunchDescription[(]')
    bad = next(key for key, each in found.items() if each is None or each.value != wanted[key])
    try_ = parameter_advice(run, name, code or str(wanted[bad]), found[bad], given, try_)
    if given and name not in given:
        raise Missing(f'the parameter {name} of the Node', name=name, among=given, try_=try_, where=where)
    thing, asked = f'the parameter {name} of {executable}', {key: str(value) for key, value in wanted.items()}
    seen = _by_run(run, {key: value_and_origin(each) for key, each in found.items()})
    if len(set(asked.values())) == 1:
        raise Mismatch(thing, _by_run(run, asked), seen, where=where, try_=try_)
    words = f'{thing} should be {wanted[bad]} in the run with {run.scenario(bad).words}'
    raise Failure(words, expected=_by_run(run, asked), seen=seen, where=where, try_=try_)


def parameter_advice(run: Evidence, name: str, code: str, seen: Parameter | None, given: Iterable[str], try_: Advice) -> Advice:
    """Return advice that fits what the launch file passes to a node: correct the name, replace the value, or pass a value.

    :param code: the code of the expected value.
    :param seen: the parameter that the node has.
    :param given: the names of the parameters that the launch file passes to the node.
    :param try_: the advice for a launch file that passes no value.
    """
    from edulaunch.engine.nearest import nearest

    if seen is None or seen.origin == 'default':
        close = nearest(name, given)
        return f'write {name} instead of {close} in the parameters of the Node' if close and close != name else try_
    argument = seen.origin.removeprefix(FROM_ARGUMENT)
    if argument != seen.origin and written_text(described_defaults(run.first).get(argument) or '') == str(seen.value):
        return try_  # the launch file passes no value: the argument has its default
    used = re.fullmatch(r"LaunchConfiguration\('(\w+)'\)|\$\(var (\w+)\)", code)
    return (
        f'use the launch argument {used[1] or used[2]} as the value of {name}: {code}'
        if used
        else f'write {code} as the value of {name}'
    )


class MissingParameterFile(Failure):
    """Launch could not find a parameter file, so advice about a single parameter would not help."""

    fits_rubric = False


FROM_ARGUMENT = 'launch argument '
INSTALL = 'add this file to data_files in setup.py, or correct its path in the launch file'
NOT_A_FILE = re.compile(r'Parameter file path is not a file: ([^\n]+)')


def refuse_missing_file(run: Evidence, wrong: Iterable[Parameter | None], package: str, executable: str | None = None) -> None:
    """Fail if none of the wrong parameters has a value from the launch file, and launch has reported a missing parameter file.

    :param wrong: the parameters with wrong values. None represents a parameter that the node does not have.
    :raises MissingParameterFile: with the path of the file and the place of the Node.
    """
    if any(parameter is not None and parameter.origin != 'default' for parameter in wrong):
        return
    for recording in run.values():
        missing = next(
            (
                found[1]
                for row in getattr(recording, 'output', ())
                if row.process == 'launch' and (found := NOT_A_FILE.search(row.text))
            ),
            '',
        )
        if missing:
            own = [recording.processes[position] for position in processes_of(recording, package, executable)]
            raise MissingParameterFile(
                f'the parameter file {missing} does not exist',
                expected='a parameter file at this path',
                seen='launch starts the node without the parameters of this file',
                where=run.source.own(own[0].origin if own else None),
                try_='create this file, or correct its path in the launch file' if '/share/' not in missing else INSTALL,
            )


def _by_run(run: Evidence, texts: Mapping[str, str]) -> str:
    """Return one string if it is the same for all runs. Otherwise, return a line for each run, with the arguments of the run."""
    if len(set(texts.values())) == 1:
        return next(iter(texts.values()))
    return '\n'.join(f'{text} with {run.scenario(name).words}' for name, text in texts.items())
