"""The rubric of broken_follow.launch.py: a chain of three turtles with three mistakes.

In its two runs, the teacher drives at different speeds. Each mistake breaks one link of the chain and has one check. The
last check measures the end of the chain.
"""

from __future__ import annotations

from random import Random

from edugrade import Evidence, Failure, Missing, Rubric, Scenario, check
from edugrade.library.circle_fit import fit_circle
from edugrade.library.deaths import refuse_dead, refuse_gone
from edugrade.library.following import require_copy, require_driver, require_near, require_pursuit
from edugrade.library.frames import require_broadcast
from edugrade.library.launched import find_processes, require_process
from edugrade.library.movement import turtle_track
from edugrade.library.node_graph import loose_ends
from edugrade.library.parameters import require_parameter

TURN = 0.5  # angular speed that the teacher's file sets, in rad/s
SETTLED_S = 12.0
ELSE = 'find out whether another node than the listener drives turtle2'
LISTENER = ('turtle_tf2_py', 'turtle_tf2_listener')


def scenarios(random: Random) -> list[Scenario]:
    """Return a run with a slow teacher and a run with a fast one."""
    slow, fast = random.randint(40, 70) / 100, random.randint(95, 130) / 100
    return [Scenario('slow', {'speed': f'{slow:.2f}'}, 18.0), Scenario('fast', {'speed': f'{fast:.2f}'}, 18.0)]


@check()
def no_node_dies(run: Evidence) -> None:
    """No node dies before the end"""
    refuse_dead(run)
    refuse_gone(run)


@check(needs=[no_node_dies])
def teacher_drives(run: Evidence) -> None:
    """The teacher drives a circle at the requested speed"""
    for name, recording in run.items():
        radius = float(run.scenario(name).arguments['speed']) / TURN
        circle = fit_circle([(x, y) for t, x, y in turtle_track(recording, '/teacher/turtle1/pose') if t > 2.0])
        if not (circle is not None and abs(circle.radius - radius) <= 0.05 * radius):
            seen = 'no circle' if circle is None else f'a circle with a radius of {circle.radius:.2f} m'
            raise Failure(
                f'the teacher should drive a circle with a radius of {radius:.2f} m',
                expected=f'a circle with a radius of {radius:.2f} m',
                seen=seen,
                where=run.source.place,
                try_="restore the teacher's part of the file: it has no mistake",
            )


@check(points=3, needs=[teacher_drives])
def turtle1_copies(run: Evidence) -> None:
    """turtle1 copies the teacher"""
    require_process(run, 'turtlesim', 'mimic')
    try:
        require_copy(
            run,
            '/teacher/turtle1',
            '/turtle1',
            'check the remappings of the Node of mimic',
            '\n'.join(loose_ends(run.first, 'turtlesim', 'mimic')),
        )
    except Failure as failure:
        failure.where = run.source.own(find_processes(run.first, 'turtlesim', 'mimic')[0].origin)
        raise
    require_driver(run, '/turtle1', 'turtlesim', 'mimic')


@check(points=1, needs=[no_node_dies])
def turtle1_is_on_tf(run: Evidence) -> None:
    """A broadcaster publishes the frame turtle1 with the parent world"""
    require_broadcast(run, 'turtle1', 'restore the Node of broadcaster1')


@check(points=3, needs=[no_node_dies])
def turtle2_is_on_tf(run: Evidence) -> None:
    """A broadcaster publishes the frame turtle2 with the parent world"""
    for recording in run.values():
        if not turtle_track(recording, '/turtle2/pose'):
            raise Missing(
                'the turtle turtle2',
                seen='no pose of this turtle',
                where=run.source.place,
                try_='restore the Node of turtle_tf2_listener, which spawns turtle2',
            )
    advice = 'compare the turtle name of each broadcaster with the name of the turtle that the listener spawns'
    require_broadcast(run, 'turtle2', advice)


@check(points=3, needs=[no_node_dies])
def target_is_turtle1(run: Evidence) -> None:
    """The listener's parameter target_frame is turtle1"""
    require_process(run, *LISTENER)
    require_parameter(
        run, *LISTENER, 'target_frame', dict.fromkeys(run, 'turtle1'), "add parameters=[{'target_frame': 'turtle1'}] to the Node"
    )


@check(points=2, needs=[turtle1_copies, turtle1_is_on_tf, turtle2_is_on_tf, target_is_turtle1])
def turtle2_follows(run: Evidence) -> None:
    """turtle2 stays close behind turtle1"""
    for name, recording in run.items():
        speed = float(run.scenario(name).arguments['speed'])
        # The listener covers half of the distance in each second, so at speed v it is 2 v behind.
        require_near(run, name, turtle_track(recording, '/turtle1/pose'), '/turtle2', 2 * speed + 0.3, SETTLED_S, ELSE)
        require_pursuit(run, name, '/turtle1', '/turtle2', SETTLED_S, ELSE)
    require_driver(run, '/turtle2', *LISTENER)


RUBRIC = Rubric(
    title='Repair: the teacher, turtle1 and turtle2',
    scenarios=scenarios,
    checks=[no_node_dies, teacher_drives, turtle1_copies, turtle1_is_on_tf, turtle2_is_on_tf, target_is_turtle1, turtle2_follows],
)
