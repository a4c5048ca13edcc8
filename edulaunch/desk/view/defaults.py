"""Find the defaults of parameters whose values come from a launch file or a command line.

A recording contains only the values.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import lru_cache
from typing import Any

from edulaunch.advice.explaining.explained import declared_parameters
from edulaunch.advice.explaining.source_ends import read_defaults
from edulaunch.advice.explaining.systems import source_files
from edulaunch.engine.packages import Index
from edulaunch.engine.underlay_place import underlay_prefix

MOST_PROGRAMS = 30
"""The page shows no defaults for a launch with more different programs than this."""


def defaults_of(
    nodes: Iterable[Sequence[Any]], processes: Iterable[Any], parameters: Iterable[Sequence[Any]], index: Index | None = None
) -> list[list[Any]]:
    """Return [node, parameter, default] for the nodes with parameter overrides, if the defaults are known.

    To find the defaults of a program of edulaunch, run the program for half a second in another simulation. For a student's
    program, read its source.

    :param nodes: the rows of a recording about nodes.
    :param processes: the rows of a recording about processes.
    :param parameters: the rows of a recording about parameters.
    :param index: finds the packages of students. If None, only the packages of edulaunch are known.
    """
    programs = {row['name']: (row['package'], row['executable']) for row in processes if row['package'] and row['executable']}
    given = dict.fromkeys(row[1] for row in parameters if row[4] != 'default')
    owners = {row[0]: programs[row[1]] for row in nodes if row[0] in given and row[1] in programs}
    known = dict.fromkeys(owners.values())
    if len(known) > MOST_PROGRAMS:
        return []
    defaults = {program: _defaults(*program, index) for program in known}
    return [[node, name, _plain(value)] for node, program in owners.items() for name, value in defaults[program].items()]


def _plain(value: Any) -> Any:
    return value if value is None or isinstance(value, (bool, int, float, str)) else list(value)


def _defaults(package: str, executable: str, index: Index | None) -> dict[str, Any]:
    places = Index((), ()) if index is None else index
    if places.prefix(package) == underlay_prefix():
        return _of_built_in(package, executable)
    return read_defaults(source_files(places, package, executable))


@lru_cache(maxsize=64)
def _of_built_in(package: str, executable: str) -> dict[str, Any]:
    return declared_parameters(package, executable, ())
