"""Checks of YAML rubrics that measure positions, frames and paths."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import isfinite, tau

from edulaunch.engine.recording.frames import frame_links

from ..evidence import Advice, Evidence, Failure, Missing
from ..library.circle_fit import fit_circle
from ..library.following import driven_track, require_driver, require_near, require_pursuit
from ..library.frames import numbers, require_frame, tilt, transforms, yaw
from ..library.launched import stranger
from ..library.movement import Track, command_topics, length, odometry_track, since, turtle_track
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
            turtles = [topic.split('/')[-2] for topic in one.recording.topics if topic.endswith('/pose')]
            seen = ', '.join(turtles) or 'no turtle'
            raise Missing(f'the turtle {wanted["turtle"]}', name=str(wanted['turtle']), among=turtles, seen=seen, **advice)
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
                when = 'the end' if worst is track[-1] else f'{worst[0]:.2f} s'
                thing = f'the {key} of the turtle {wanted["turtle"]} at {when}'
                one.require_close(thing, worst[axis], asked, 0.05, f'write {one.code(key)} as the {key} of the turtle', unit='m')


@kind('The frame {child} has the parent {parent}', 'child parent', f'x y z yaw by {MEASURE}')
def frame(run: Evidence, wanted: Wanted) -> None:
    """Require a frame with its parent and, optionally, its position, its yaw and the package that broadcasts it. A frame with a
    yaw must have no roll and no pitch.
    """
    child, parent = wanted['child'], wanted['parent']
    tree = 'check the tree of frames with ros2 run tf2_tools view_frames'
    steps = ('check the names of the frames', tree, f'publish the frame {child} with the parent {parent}')
    require_frame(run, child, parent, wanted.try_ or steps)
    for one in wanted.of_each(run):
        _refuse_broadcasters(one, child, wanted['by'])
        for sent in transforms(run, one.scenario)[child]:
            place, axes = sent.frame.translation, [key for key in ('x', 'y', 'z') if key in wanted]
            wrong = [key for key in axes if not abs(place['xyz'.index(key)] - one.number(key)) <= one.tolerance(0.01)]
            for key in wrong:
                thing, seen = f'the {key} of the frame {child} relative to {parent}', place['xyz'.index(key)]
                one.require_close(thing, seen, one.number(key), 0.01, _place_advice(one, wrong), f'at {numbers(place)}', 'm')
            if 'yaw' in wanted:
                advice, asked, seen = _place_advice(one, ['yaw']), one.number('yaw'), yaw(sent.frame)
                turned = seen + round((asked - seen) / tau) * tau  # half a turn is the same to the left and to the right
                seen = turned if abs(turned - asked) <= 1.0 else seen
                one.require_close(f'the yaw of the frame {child}', seen, asked, 0.01, advice, unit='rad')
                one.require_close(f'the tilt of the frame {child}', tilt(sent.frame), 0.0, 0.01, advice, unit='rad')


def _refuse_broadcasters(one: OfRun, child: str, package: str) -> None:
    """Refuse a node that broadcasts the frame, but is not of this package. Any node may broadcast other frames."""
    names = frame_links(one.recording)[child].broadcasters if package else ()
    for topic in ('/tf', '/tf_static') if package else ():
        node, process = stranger(one.recording, topic, package, names=names) or (None, None)
        if node is not None:
            raise Failure(
                f'{node.name} broadcasts the frame {child}, which only {package} may broadcast',
                expected=f'only {package} broadcasts {child}',
                seen=f'the process {node.process} broadcasts it',
                where=process.origin if process else None,
                try_=f'remove the broadcast of {child} from {node.process}',
            )


def _place_advice(one: OfRun, keys: Sequence[str]) -> Advice:
    """Return the rubric's advice, or advice to change some numbers of a transform."""
    child = one.wanted['child']
    values: list[str] = []
    for key in keys:
        argument = ARGUMENT.fullmatch(str(one.wanted[key]))
        thing = f'its {key}' if values else f'the {key} of the frame {child}'
        values.append(f'{thing} to ' + (f'the launch argument {argument[1]}' if argument else f'{one.number(key):g}'))
    what = 'check the rotation of the frame' if keys == ['yaw'] else 'check the position of the frame'
    steps = (what, f'check the {" and the ".join(keys)} of the frame {child}', f'set {", and ".join(values)}')
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
                where=run.source.place,
                try_=wanted.try_ or _wheel_advice(one, who),
            )


@kind('{turtle} drives a circle with the radius {radius}', 'radius', f'turtle odometry since driver {MEASURE}')
def circle(run: Evidence, wanted: Wanted) -> None:
    """Require that a turtle or the robot drives a circle with a given radius."""
    for one, who, track in _tracks(run, wanted):
        found = fit_circle([(x, y) for _, x, y in since(track, wanted['since'] or 2.0)])
        radius = one.number('radius')
        if found is None or not found.residual <= max(one.tolerance(0.02 * radius), 0.05 * radius):
            moves, advice = length(track) > STANDS_M, _wheel_advice(one, who)
            failure = Failure(
                f'{who} does not drive a circle in the run with {one.words}',
                expected=f'a circle with a radius of {radius:g} m',
                seen=f'a path of {length(track):.2f} m that is not a circle' if moves else f'{who} does not move',
                where=run.source.place,
                try_=wanted.try_ if wanted.try_ and advice.startswith('find') else advice,
            )
            failure.fits_rubric = failure.try_ == wanted.try_
            raise failure
        one.require_close(f'the radius of the circle of {who}', found.radius, radius, 0.02 * radius, unit='m')


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


def _wheel_advice(one: OfRun, who: str) -> str:
    """Return advice about the velocities of a turtle or robot that does not drive as expected."""
    name = f'/{str(one.wanted["turtle"]).strip("/")}' if one.wanted['turtle'] else ''
    usual, place = f'{name}/cmd_vel', f'{name}/pose' if name else str(one.wanted['odometry'] or '/odom')
    topics = sorted(command_topics(one.recording, place)) or [usual]
    sent = (
        [message for topic in topics for _, message in one.recording.messages(topic)] if topics[0] in one.recording.topics else []
    )
    if not sent:
        return f'find out why no node publishes velocities on {topics[0]}'
    return f'check the values of the velocities on {topics[0]}: linear.x moves {who} ahead, and angular.z turns it'


def _tracks(run: Evidence, wanted: Wanted) -> Iterator[tuple[OfRun, str, Track]]:
    """Yield (values of the check, name, track) of the turtle or robot for each run."""
    for one in wanted.of_each(run):
        _require_driver(one, str(wanted['turtle']))
        if wanted['turtle']:
            name = f'/{str(wanted["turtle"]).strip("/")}'
            yield one, str(wanted['turtle']), driven_track(one.alone, one.scenario, name)
        else:
            yield one, 'the robot', odometry_track(one.recording, wanted['odometry'] or '/odom')
