"""Run one launch file in simulation and in reality."""

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
"""The additional seconds for the real run, until it has shown everything that the simulation showed."""

LATE_S = 1.0
MOST_ORDERS = 8
OTHER_SEEDS = (1, 2)


class Pair(NamedTuple):
    """The result of a comparison: the differences, split by whether they count, and the observations of both runs.

    Differences that depend on the computer's speed or on random numbers do not count. Neither do differences of programs that
    had not started when the run was interrupted.
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
    """Run a launch file in simulation, as long as the real run may take, and then in reality.

    Some differences depend on the order in which programs start. In further simulations, programs therefore start as late as
    in reality, at the same time of day. Other differences depend on random numbers; see :func:`by_chance`. The result
    contains the remaining differences.

    :param seconds: the simulated seconds until SIGINT ends the run.
    :param is_known: returns whether a difference is known. The run does not wait for known differences.
    :raises UnusableInput: when the file cannot be launched, or the real rclpy is not installed.
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
    """Yield possible delays: of all programs, of only the programs with nodes (a command waited for them), or of one program."""
    yield late
    yield {name: late_s for name, late_s in late.items() if simulated.programs[name].nodes}
    for name in sorted(late)[:MOST_ORDERS]:
        yield {name: max(late[name], LATE_S)}


def delays(simulated: Observation, real: Observation) -> dict[str, float]:
    """Return how many seconds later than in simulation each program started in the real run.

    A program has started when its first node exists or it ends by itself. If a signal ended it earlier, the end of the run
    counts.
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
