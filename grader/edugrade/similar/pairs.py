"""Which submissions are more alike than the task makes them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from itertools import combinations
from math import log
from typing import NamedTuple

from .fingerprints import Code


class Work(NamedTuple):
    """A submission: whose it is, its path, its texts by name, and its launch graph."""

    student: str
    path: str
    texts: dict[str, Code]
    graph: tuple[str, ...]

    @property
    def prints(self) -> set[int]:
        """All fingerprints of its texts."""
        return {number for code in self.texts.values() for number in code.prints}


class Pair(NamedTuple):
    """Two submissions, how much of the smaller one's own code the other one has (0 to 1), and of the launch graphs."""

    one: Work
    two: Work
    code: float
    graph: float
    shared: frozenset[int]


def alike(works: Sequence[Work], given: Iterable[int] = (), least: float = 0.5) -> list[Pair]:
    """The pairs of different students with at least that much code in common, the most alike first.

    What was handed out counts nothing, and what many have counts little: there are not many ways to write a launch file.

    :param given: fingerprints of what was handed out.
    """
    handed_out = set(given)
    own = [work.prints - handed_out for work in works]
    weights = _weights(own)
    lines = _weights([set(work.graph) for work in works])
    pairs = []
    for (one, here), (two, there) in combinations(zip(works, own, strict=True), 2):
        if one.student == two.student:
            continue
        shared = here & there
        code = _share(shared, here, there, weights)
        if code >= least:
            common = set(one.graph) & set(two.graph)
            pairs.append(Pair(one, two, code, _share(common, set(one.graph), set(two.graph), lines), frozenset(shared)))
    return sorted(pairs, key=lambda pair: (-pair.code, pair.one.path, pair.two.path))


def _weights(sets: Sequence[set[int]] | Sequence[set[str]]) -> dict[object, float]:
    """Rare things weigh more: what two of many have 1, what everybody has nearly nothing."""
    counts: Counter[object] = Counter(item for items in sets for item in items)
    most = log(max(len(sets), 2) + 1) - log(2)
    return {item: 0.05 + (log(len(sets) + 1) - log(max(count, 2))) / most for item, count in counts.items()}


def _share(
    shared: set[int] | set[str], here: set[int] | set[str], there: set[int] | set[str], weights: dict[object, float]
) -> float:
    smaller = min(sum(weights[item] for item in items) for items in (here, there))
    return round(sum(weights[item] for item in shared) / smaller, 3) if smaller else 0.0
