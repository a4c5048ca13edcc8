"""Checks whether a turtle reaches a goal, stays near it, or follows it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..evidence import Advice, Evidence, Failure
from .identity import nodes_of
from .launched import refuse_strangers, stranger
from .movement import Track, command_topics, distances, farthest, fastest, length, progress_towards, pushed, since, turtle_track

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording

POSE = 'turtlesim/msg/Pose'
FASTEST_M_S = 20.0  # the listener drives half of the distance in a second, in a world 11 m wide
LAST_S = 1.0  # greatest age of the last pose of a turtle that exists until the end
MOST_PUSHED_M = 0.1
LEAST_WAY_M = 0.5  # distance that a turtle must drive to reach a goal
LEAST_SHARE = 0.4  # share of the distance of a moving goal; a follower that takes short cuts travels less than its goal


def require_near(run: Evidence, scenario: str, goal: Track, follower: str, bound_m: float, since_s: float, try_: Advice) -> None:
    """Require that a follower is never more than `bound_m` metres from its goal after `since_s` simulated seconds.

    :param goal: the position of the goal over time.
    :param follower: the turtle, such as ``/turtle2``.
    :raises Failure: with the largest distance and its time.
    """
    track = driven_track(run, scenario, follower)
    worst = farthest(distances(goal, track), since_s)
    is_there = worst is not None and track[-1][0] >= run[scenario].duration_s - LAST_S
    if not (worst is not None and is_there and worst[1] <= bound_m):
        name = follower.strip('/')
        seen = f'{worst[1]:.2f} m away at {worst[0]:.2f} s' if worst is not None and is_there else f'{name} does not exist then'
        raise Failure(
            f'{name} is too far from its goal in the run with {run.scenario(scenario).words}',
            expected=f'at most {bound_m:g} m away after {since_s:g} s',
            seen=seen,
            where=run.source.place,
            try_=try_,
        )


def require_arrival(run: Evidence, scenario: str, follower: str, try_: Advice) -> None:
    """Require that a turtle has driven to a goal that does not move.

    :param follower: the turtle, such as ``/turtle2``.
    :raises Failure: if the turtle drove no distance, because it was at the goal from the beginning.
    """
    track = driven_track(run, scenario, follower)
    if not length(track) >= LEAST_WAY_M:
        raise Failure(
            f'{follower.strip("/")} does not drive to its goal in the run with {run.scenario(scenario).words}',
            expected=f'a distance of at least {LEAST_WAY_M:g} m',
            seen=f'a distance of {length(track):.2f} m, because the turtle was at the goal from the beginning',
            where=run.source.place,
            try_=try_,
        )


def require_driver(run: Evidence, turtle: str, package: str, executable: str | None = None) -> None:
    """Require that only one program sends commands to a turtle, so that its movement shows the behaviour of this program.

    :param turtle: the turtle, such as ``/turtle2``, or '' for the robot.
    :param package: the package of the program.
    :param executable: the only program of the package that may send commands (default: all of its programs).
    :raises Failure: with the name of another node that commands the turtle.
    """
    place_topic, usual = f'{turtle}/pose' if turtle else '/odom', f'{turtle}/cmd_vel'
    for recording in run.values():
        for topic in sorted(command_topics(recording, place_topic) or {usual}):
            found = stranger(recording, topic, package, executable)
            if found is not None and topic != usual:
                node, process = found
                name, driver = turtle.strip('/') or 'the robot', ' '.join(filter(None, (package, executable)))
                raise Failure(
                    f'{node.name} drives {name}, which only {driver} may drive',
                    expected=f'the simulator receives the velocities of {name} on {usual}',
                    seen=f'it receives them on {topic}, and the process {node.process} publishes on this topic',
                    where=process.origin if process else None,
                    try_=f'remove the remapping of {usual} from the Node of the simulator',
                )
            refuse_strangers(recording, topic, package, executable)


def require_pursuit(run: Evidence, scenario: str, goal: str, follower: str, since_s: float, try_: Advice) -> None:
    """Require that a turtle drives towards a moving turtle, for at least LEAST_SHARE of the distance that this turtle drives.

    A turtle that waits in the middle of the goal's path is near the goal, but does not follow it.

    :param goal: the moving turtle, such as ``/turtle1``.
    :param follower: the turtle that must follow, such as ``/turtle2``.
    :param since_s: the simulated time in seconds from which the distances count.
    :raises Failure: with both distances.
    """
    recording = run[scenario]
    leader = turtle_track(recording, f'{goal}/pose')
    track = since(driven_track(run, scenario, follower), since_s)
    way, towards = length(since(leader, since_s)), progress_towards(leader, track)
    if not towards >= LEAST_SHARE * way > 0.0:
        raise Failure(
            f'{follower.strip("/")} does not follow {goal.strip("/")} in the run with {run.scenario(scenario).words}',
            expected=f'a movement towards {goal.strip("/")}, which drives {way:.2f} m after {since_s:g} s',
            seen=f'a movement of {towards:.2f} m towards {goal.strip("/")}',
            where=run.source.place,
            try_=try_,
        )


def require_copy(run: Evidence, original: str, copy: str, try_: Advice, hint_seen: str = '') -> None:
    """Require that a turtle drives as far as the turtle that it copies, within 5 %. The original must drive at least half a
    metre.

    The program `mimic` must receive the poses of the original, or the poses of another copy.

    :param original: the turtle to copy, such as ``/turtle1``.
    :param copy: the turtle that must copy it.
    :param hint_seen: another observation that explains the failure.
    :raises Failure: with both distances, or with the topics from which `mimic` receives poses.
    """
    for scenario, recording in run.items():
        there, here = (length(turtle_track(recording, f'{turtle}/pose')) for turtle in (original, copy))
        if not (there >= 0.5 and abs(here - there) <= 0.05 * there):
            seen = f'{original} drives {there:.2f} m, {copy} drives {here:.2f} m'
            raise Failure(
                f'{copy} does not copy {original} in the run with {run.scenario(scenario).words}',
                expected='both drive the same distance',
                seen='\n'.join(filter(None, (seen, hint_seen))),
                where=run.source.place,
                try_=try_,
            )
        heard = copied_poses(recording, copy)
        if f'{original}/pose' not in heard:
            raise Failure(
                f'{copy} copies another turtle than {original} in the run with {run.scenario(scenario).words}',
                expected=f'mimic subscribes to {original}/pose',
                seen=f'mimic subscribes to {", ".join(heard) or "no pose"}',
                where=run.source.place,
                try_=try_,
            )


def copied_poses(recording: Recording, copy: str) -> list[str]:
    """Return the topics with the poses that a turtle copies through `mimic`, directly or through other copies."""
    mimics = [recording.nodes[position] for position in nodes_of(recording, 'turtlesim', 'mimic')]
    found, turtles = {}, [copy]
    for turtle in turtles:
        commands = command_topics(recording, f'{turtle}/pose') or {f'{turtle}/cmd_vel'}
        for node in mimics:
            if commands.isdisjoint(name for name, _ in node.publishers):
                continue
            for name, kind in node.subscriptions:
                if kind == POSE and name not in found:
                    found[name] = turtle
                    turtles.append(name.rpartition('/')[0])
    return list(found)


def driven_track(run: Evidence, scenario: str, turtle: str) -> Track:
    """Return the track of a turtle that drives.

    :raises Failure: if the turtle was teleported.
    """
    track = turtle_track(run[scenario], f'{turtle}/pose')
    if not fastest(track) <= FASTEST_M_S:
        raise Failure(
            f'{turtle.strip("/")} jumps in the run with {run.scenario(scenario).words}',
            expected=f'a speed of {FASTEST_M_S:g} m/s or less',
            seen=f'a speed of {fastest(track):.0f} m/s between two poses',
            where=run.source.place,
            try_='move it with velocities on its topic cmd_vel, not with the services teleport_absolute or teleport_relative',
        )
    away = pushed(run[scenario], f'{turtle}/pose')
    if not away <= MOST_PUSHED_M:
        raise Failure(
            f'{turtle.strip("/")} does not drive by itself in the run with {run.scenario(scenario).words}',
            expected='movement only with the velocities on the topic cmd_vel',
            seen=f'a movement of {away:.2f} m without a velocity',
            where=run.source.place,
            try_='move it with velocities on its topic cmd_vel, not with the services teleport_absolute or teleport_relative',
        )
    return track


def still(place: tuple[float, float]) -> Track:
    """Return the track of a goal that does not move."""
    return [(0.0, *place)]
