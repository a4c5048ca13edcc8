"""Whether one turtle comes to, or stays near, a goal."""

from __future__ import annotations

from ..evidence import Evidence
from ..failure import Failure
from .movement import Track, distances, farthest, length, turtle_track


def require_near(run: Evidence, scenario: str, goal: Track, follower: str, bound_m: float, since_s: float, try_: str) -> None:
    """From a time on, a follower is never farther from its goal than `bound_m` metres.

    :param goal: where the goal is over time.
    :param follower: the turtle, such as ``/turtle2``.
    :raises Failure: with the largest distance and when it was.
    """
    worst = farthest(distances(goal, turtle_track(run[scenario], f'{follower}/pose')), since_s)
    if worst is None or worst[1] > bound_m:
        name = follower.strip('/')
        seen = f'no {name} then' if worst is None else f'{worst[1]:.2f} m at {worst[0]:.2f} s'
        raise Failure(
            f'{name} is too far from its goal, when launched with {run.scenario(scenario).words}',
            expected=f'at most {bound_m:g} m from {since_s:g} s on',
            seen=seen,
            where=run.source.place,
            try_=try_,
        )


def require_copy(run: Evidence, original: str, copy: str, try_: str, hint_seen: str = '') -> None:
    """In every run a turtle drives as far as the one it copies, give or take 5 %; the original must move.

    :param hint_seen: what else was seen that explains why it does not.
    :raises Failure: with both distances.
    """
    for scenario, recording in run.items():
        there, here = (length(turtle_track(recording, f'{turtle}/pose')) for turtle in (original, copy))
        if there < 0.5 or abs(here - there) > 0.05 * there:
            seen = f'{original} travels {there:.2f} m, {copy} {here:.2f} m'
            raise Failure(
                f'{copy} does not do what {original} does, when launched with {run.scenario(scenario).words}',
                expected='the same movement',
                seen='\n'.join(filter(None, (seen, hint_seen))),
                where=run.source.place,
                try_=try_,
            )


def still(place: tuple[float, float]) -> Track:
    """The track of a goal that stays where it is."""
    return [(0.0, *place)]
