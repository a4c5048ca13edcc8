"""One launch file in both worlds."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import NamedTuple

from edulaunch.extras.comparing.deciding import informs, is_pace
from edulaunch.extras.comparing.differing import Difference, by_chance, differences, not_up, subject
from edulaunch.extras.comparing.for_real import run_for_real
from edulaunch.extras.comparing.isolated import in_isolation
from edulaunch.extras.comparing.observation import Observation
from edulaunch.extras.comparing.simulated import simulate

PATIENCE_S = 10.0
"""So much longer a real run may take, until everything has been seen that the simulation showed."""

LATE_S = 1.0
MOST_ORDERS = 8
OTHER_SEEDS = (1, 2)


class Pair(NamedTuple):
    """What differs between the two worlds, what differs only by how fast the computer is, what may be left out since it depends
    on random numbers, who is left out since Ctrl-C came before they were up, and what was seen in each.
    """

    found: list[Difference]
    slow: list[Difference]
    chance: list[Difference]
    not_up: set[str]
    simulated: Observation
    real: Observation


def compare(
    path: str,
    file: str | None,
    arguments: Mapping[str, str],
    seconds: float,
    workspaces: Sequence[str] = (),
    is_known: Callable[[Difference], bool] = lambda difference: False,
) -> Pair:
    """Run it in simulation, for `seconds` and for as long as the real run may become, and for real. What differs from both may
    still be a matter of who comes up when: in further simulations programs come up as late as they did for real, at the same
    time of day. Or of random numbers: see :func:`by_chance`. What differs from all simulations differs.

    :param seconds: until Ctrl-C in simulation.
    :param is_known: what nobody waits for.
    :raises UnusableInput: when it cannot be launched at all, or the real rclpy is not installed.
    """
    what = os.path.abspath(path) if not file and os.path.exists(path) else path, file, arguments
    workspaces = [os.path.abspath(folder) for folder in workspaces]
    simulated = [in_isolation(simulate, *what, length_s, workspaces) for length_s in (seconds, seconds + PATIENCE_S)]
    goals = [each.until_asked() for each in simulated]
    is_enough = lambda seen: all(is_known(each) or is_pace(each) for each in differences(goals, seen))  # noqa: E731
    real = in_isolation(run_for_real, *what, seconds, workspaces, is_enough, PATIENCE_S)
    late = delays(simulated[0], real)

    def counts(difference: Difference) -> bool:
        return not is_known(difference) and not informs(difference, simulated[0], real, max(late.values(), default=0.0))

    found = differences(simulated, real)
    for each_late in _lates(simulated[0], late):
        if any(map(counts, found)):
            simulated.append(in_isolation(simulate, *what, real.asked_s, workspaces, each_late, real.start_s))
            found = differences(simulated, real)
    chance: list[Difference] = []
    if any(map(counts, found)):
        others = [in_isolation(simulate, *what, real.asked_s, workspaces, late, real.start_s, seed) for seed in OTHER_SEEDS]
        subjects = by_chance([simulated[2], *others])
        chance = [each for each in found if subject(each) in subjects]
        found = [each for each in differences([*simulated, *others], real) if subject(each) not in subjects]
    slow = [each for each in found if not is_known(each) and not counts(each)]
    return Pair([each for each in found if each not in slow], slow, chance, not_up(simulated[0], real), simulated[0], real)


def _lates(simulated: Observation, late: dict[str, float]) -> Iterator[dict[str, float]]:
    """Who may have been how late: all programs; those with nodes alone, where a command waited for them; or any one alone."""
    yield late
    yield {name: late_s for name, late_s in late.items() if simulated.programs[name].nodes}
    for name in sorted(late)[:MOST_ORDERS]:
        yield {name: max(late[name], LATE_S)}


def delays(simulated: Observation, real: Observation) -> dict[str, float]:
    """How much later than in simulation each program came up for real, in seconds: until its first node was there, or until it
    ended by itself; for one that a signal ended first, until everything was over.
    """
    late: dict[str, float] = {}
    for name, here in simulated.programs.items():
        there = real.programs.get(name)
        if there is not None:
            was_ended = there.ended_s is not None and there.signalled_s < there.ended_s
            ended_s = real.asked_s + LATE_S if was_ended else there.ended_s
            came = min((real.nodes[node] for node in here.nodes if node in real.nodes), default=ended_s)
            meant = min((simulated.nodes[node] for node in here.nodes if node in simulated.nodes), default=here.ended_s)
            if came is not None and meant is not None and meant < float('inf'):
                late[name] = max(0.0, (came - there.started_s) - (meant - here.started_s))
    return late
