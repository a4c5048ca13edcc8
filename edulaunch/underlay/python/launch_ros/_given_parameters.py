"""What is given to the parameters of a node, and which of it counts."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cached_property
from typing import Any, NamedTuple

from edulaunch.graph.parameters import pattern_matches


class Given(NamedTuple):
    """One value for one parameter.

    :ivar pattern: of the nodes that it is for.
    :ivar origin: where it was written, in words.
    :ivar file, line: the same, as far as it is known; '' and 0 when it is not.
    :ivar is_of_a_file: whether a parameter file says so, rather than the launch file.
    """

    pattern: str
    name: str
    value: Any
    origin: str
    file: str = ''
    line: int = 0
    is_of_a_file: bool = False


def in_force(given: Sequence[Given], full_name: str) -> list[Given]:
    """What means the node of that name, in rcl's order: of two for one parameter the later one counts.

    All that stands under one pattern comes where that pattern was met first.
    """
    ranks: dict[str, int] = {}
    for one in given:
        ranks.setdefault(one.pattern, len(ranks))
    meant = {pattern for pattern in ranks if pattern_matches(pattern, full_name)}
    return sorted((one for one in given if one.pattern in meant), key=lambda one: ranks[one.pattern])


class ParameterOrigins(Mapping[str, str]):
    """Parameter name -> origin, of the values that count and that no parameter file gives; found out when somebody asks.

    :param in_force: gives everything that is given, as :func:`in_force` orders it.
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
