"""Whether one turtle comes to, or stays near, a goal."""

from __future__ import annotations

from ..evidence import Evidence, Failure
from .launched import refuse_strangers
from .movement import Track, distances, farthest, fastest, length, progress_towards, since, turtle_track

FASTEST_M_S = 20.0  # the listener drives half of the distance in a second, in a world 11 m wide
LAST_S = 1.0  # a turtle is there to the end when its last pose is not older than this
LEAST_WAY_M = 0.5  # of a turtle that comes to a goal
LEAST_SHARE = 0.4  # of the way of a moving goal; whoever cuts its corners travels less than the goal


def require_near(run: Evidence, scenario: str, goal: Track, follower: str, bound_m: float, since_s: float, try_: str) -> None:
    """From a time on until the end, a follower is never farther from its goal than `bound_m` metres.

    :param goal: where the goal is over time.
    :param follower: the turtle, such as ``/turtle2``.
    :raises Failure: with the largest distance and when it was.
    """
    track = driven_track(run, scenario, follower)
    worst = farthest(distances(goal, track), since_s)
    is_there = worst is not None and track[-1][0] >= run[scenario].duration_s - LAST_S
    if not (worst is not None and is_there and worst[1] <= bound_m):
        name = follower.strip('/')
        seen = f'{worst[1]:.2f} m at {worst[0]:.2f} s' if worst is not None and is_there else f'no {name} then'
        raise Failure(
            f'{name} is too far from its goal, when launched with {run.scenario(scenario).words}',
            expected=f'at most {bound_m:g} m from {since_s:g} s on',
            seen=seen,
            where=run.source.place,
            try_=try_,
        )


def require_arrival(run: Evidence, scenario: str, follower: str, try_: str) -> None:
    """A turtle that should come to a goal at rest has driven there.

    :raises Failure: for one that was there from the beginning.
    """
    track = driven_track(run, scenario, follower)
    if not length(track) >= LEAST_WAY_M:
        raise Failure(
            f'{follower.strip("/")} does not come to its goal, when launched with {run.scenario(scenario).words}',
            expected=f'it drives there, at least {LEAST_WAY_M:g} m',
            seen=f'{length(track):.2f} m travelled: it was there from the beginning',
            where=run.source.place,
            try_=try_,
        )


def require_driver(run: Evidence, turtle: str, package: str, executable: str) -> None:
    """Nobody but one program commands a turtle, so what the turtle does is what this program does.

    :param turtle: such as ``/turtle2``.
    :raises Failure: naming the node that commands it besides, or instead.
    """
    for recording in run.values():
        refuse_strangers(recording, f'{turtle}/cmd_vel', package, executable)


def require_pursuit(run: Evidence, scenario: str, goal: str, follower: str, since_s: float, try_: str) -> None:
    """From a time on a turtle drives towards a moving one, for at least LEAST_SHARE of the way that the goal travels.

    Whoever stands in the middle of the goal's path is near it, and does not follow.

    :param goal: the moving turtle, such as ``/turtle1``; `follower` likewise.
    :raises Failure: with both ways.
    """
    recording = run[scenario]
    leader = turtle_track(recording, f'{goal}/pose')
    track = since(driven_track(run, scenario, follower), since_s)
    way, towards = length(since(leader, since_s)), progress_towards(leader, track)
    if not towards >= LEAST_SHARE * way > 0.0:
        raise Failure(
            f'{follower.strip("/")} does not follow {goal.strip("/")}, when launched with {run.scenario(scenario).words}',
            expected=f'it drives towards {goal.strip("/")} from {since_s:g} s on, which travels {way:.2f} m',
            seen=f'{towards:.2f} m driven towards it',
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
        if not (there >= 0.5 and abs(here - there) <= 0.05 * there):
            seen = f'{original} travels {there:.2f} m, {copy} {here:.2f} m'
            raise Failure(
                f'{copy} does not do what {original} does, when launched with {run.scenario(scenario).words}',
                expected='the same movement',
                seen='\n'.join(filter(None, (seen, hint_seen))),
                where=run.source.place,
                try_=try_,
            )


def driven_track(run: Evidence, scenario: str, turtle: str) -> Track:
    """The track of a turtle that drives. Raises Failure for one that was put somewhere (teleported)."""
    track = turtle_track(run[scenario], f'{turtle}/pose')
    if not fastest(track) <= FASTEST_M_S:
        raise Failure(
            f'{turtle.strip("/")} jumps, when launched with {run.scenario(scenario).words}',
            expected=f'it drives, at {FASTEST_M_S:g} m/s at most',
            seen=f'{fastest(track):.0f} m/s between two poses',
            where=run.source.place,
            try_='move it with velocities on its topic cmd_vel, not with the services teleport_absolute or teleport_relative',
        )
    return track


def still(place: tuple[float, float]) -> Track:
    """The track of a goal that stays where it is."""
    return [(0.0, *place)]
