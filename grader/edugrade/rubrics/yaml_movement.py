"""Checks of YAML rubrics that measure positions, frames and paths."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import isfinite, tau

from ..evidence import Evidence, Failure, Missing
from ..library.circle_fit import fit_circle
from ..library.following import driven_track, require_driver, require_near, require_pursuit
from ..library.frames import numbers, require_frame, tilt, transforms, yaw
from ..library.launched import refuse_strangers
from ..library.movement import Track, length, odometry_track, since, turtle_track
from .yaml_checks import MEASURE, kind
from .yaml_wanted import ARGUMENT, OfRun, Wanted

LAST_LOOK_S = 0.5
STANDS_M = 0.005  # a shorter path would be shown as 0.00 m


@kind('{turtle} is at its position at the end', 'turtle', f'x y since {MEASURE}')
def place(run: Evidence, wanted: Wanted) -> None:
    """Require the position of a turtle at the end of the run or, with `since`, in all its poses from that time on."""
    for one in wanted.of_each(run):
        track = _turtle(one, 'turtle')
        if not track:
            advice = {**one.advice, 'try_': wanted.try_ or f'spawn {wanted["turtle"]} with the service /spawn'}
            raise Missing(f'the turtle {wanted["turtle"]}', seen='no pose of this turtle', **advice)
        if track[-1][0] < one.recording.duration_s - LAST_LOOK_S:
            advice = {
                **one.advice,
                'try_': wanted.try_ or f'find out what removes {wanted["turtle"]}: a call of /kill, /reset or /clear',
            }
            seen = f'its last pose is at {track[-1][0]:.2f} s'
            raise Missing(f'the turtle {wanted["turtle"]} at the end of the run', seen=seen, **advice)
        samples = since(track, wanted['since']) if 'since' in wanted else track[-1:]
        for axis, key in enumerate(('x', 'y'), 1):
            if key in wanted:
                asked = one.number(key)
                worst = max(reversed(samples), key=lambda sample: abs(sample[axis] - asked))
                thing = f'{key} of {wanted["turtle"]} at the end (in m)'
                thing = thing if worst is track[-1] else f'{key} of {wanted["turtle"]} at {worst[0]:.2f} s (in m)'
                one.require_close(thing, worst[axis], asked, 0.05)


@kind('The frame {child} has the parent {parent}', 'child parent', f'x y z yaw by {MEASURE}')
def frame(run: Evidence, wanted: Wanted) -> None:
    """Require a frame with its parent and, optionally, its position, its yaw and the package that broadcasts it. A frame with a
    yaw must have no roll and no pitch.
    """
    child, advice = wanted['child'], wanted.try_ or 'check the tree of frames with ros2 run tf2_tools view_frames'
    require_frame(run, child, wanted['parent'], advice)
    for one in wanted.of_each(run):
        for topic in ('/tf', '/tf_static') if wanted['by'] else ():
            refuse_strangers(one.recording, topic, wanted['by'])
        for sent in transforms(run, one.scenario)[child]:
            place = sent.frame.translation
            for axis, key in enumerate(('x', 'y', 'z')):
                if key in wanted:
                    thing = f'the {key} of {child} relative to {sent.frame.parent}'
                    one.require_close(
                        thing, place[axis], one.number(key), 0.01, _place_advice(one, key), f'the position {numbers(place)}'
                    )
            if 'yaw' in wanted:
                asked = one.number('yaw')
                turns = round((asked - yaw(sent.frame)) / tau)  # half a turn is the same to the left and to the right
                one.require_close(f'the yaw of {child}', yaw(sent.frame) + turns * tau, asked, 0.01, _place_advice(one, 'yaw'))
                one.require_close(
                    f'the tilt of {child} by roll and pitch', tilt(sent.frame), 0.0, 0.01, _place_advice(one, 'yaw')
                )


def _place_advice(one: OfRun, key: str) -> str | Sequence[str]:
    """Return the rubric's advice, or advice to change one number of a transform."""
    argument, child = ARGUMENT.fullmatch(str(one.wanted[key])), one.wanted['child']
    value = f'the launch argument {argument[1]}' if argument else f'{one.number(key):g}'
    what = 'check the rotation of the frame' if key == 'yaw' else 'check the position of the frame'
    steps = (what, f'check the {key} of the frame {child}', f'set the {key} of the frame {child} to {value}')
    return one.wanted.try_ or steps


@kind('{turtle} drives at least {at_least} m', 'at_least', 'turtle odometry share driver')
def travels(run: Evidence, wanted: Wanted) -> None:
    """Require that a turtle or the robot drives at least a given distance."""
    for one, who, track in _tracks(run, wanted):
        way, asked = length(track), one.number('at_least')
        if not way >= asked:
            share = way / asked if wanted['share'] and isfinite(way) else 0.0
            raise Failure(
                f'{who} drives less than {asked:g} m in the run with {one.words}',
                expected=f'at least {asked:g} m',
                seen=f'{way:.2f} m',
                share=min(share, wanted['share'] or 0.0),
                **one.advice,
            )


@kind('{turtle} drives a circle with the radius {radius}', 'radius', f'turtle odometry since driver {MEASURE}')
def circle(run: Evidence, wanted: Wanted) -> None:
    """Require that a turtle or the robot drives a circle with a given radius."""
    for one, who, track in _tracks(run, wanted):
        found = fit_circle([(x, y) for _, x, y in since(track, wanted['since'] or 2.0)])
        radius = one.number('radius')
        if found is None or not found.residual <= max(one.tolerance(0.02 * radius), 0.05 * radius):
            raise Failure(
                f'{who} does not drive a circle in the run with {one.words}',
                expected=f'a circle with a radius of {radius:g} m',
                seen=f'a path of {length(track):.2f} m that is not a circle'
                if length(track) > STANDS_M
                else f'{who} does not move',
                **one.advice,
            )
        one.require_close(f'the radius of the circle of {who}', found.radius, radius, 0.02 * radius)


@kind('{follower} stays within {within} m of {goal}', 'follower goal within', 'since driver')
def follows(run: Evidence, wanted: Wanted) -> None:
    """Require that a turtle drives to another turtle, and follows it when it moves."""
    advice = wanted.try_ or 'check the frames that the listener looks up in tf'
    goal, follower = (f'/{wanted[key].strip("/")}' for key in ('goal', 'follower'))
    for one in wanted.of_each(run):
        start, track = wanted['since'] or one.recording.duration_s / 2, _turtle(one, 'goal')
        require_near(run, one.scenario, track, follower, wanted['within'], start, advice)
        _require_driver(one, follower)
        if length(since(track, start)) > 1.0:
            require_pursuit(run, one.scenario, goal, follower, start, advice)


def _turtle(one: OfRun, key: str) -> Track:
    return turtle_track(one.recording, f'/{one.wanted[key].strip("/")}/pose')


def _require_driver(one: OfRun, turtle: str) -> None:
    """Require that only the `driver` of the rubric sends commands to the turtle or robot. Without `driver`, do nothing."""
    if one.wanted['driver']:
        require_driver(one.alone, f'/{turtle.strip("/")}' if turtle else '', *one.wanted['driver'].split(maxsplit=1))


def _tracks(run: Evidence, wanted: Wanted) -> Iterator[tuple[OfRun, str, Track]]:
    """Yield (values of the check, name, track) of the turtle or robot for each run."""
    for one in wanted.of_each(run):
        _require_driver(one, str(wanted['turtle']))
        if wanted['turtle']:
            name = f'/{str(wanted["turtle"]).strip("/")}'
            yield one, str(wanted['turtle']), driven_track(one.alone, one.scenario, name)
        else:
            yield one, 'the robot', odometry_track(one.recording, wanted['odometry'] or '/odom')
