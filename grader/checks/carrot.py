"""The rubric of carrot.launch.py: a launch argument selects one of two carrots.

It has two runs, carrot:=fixed and carrot:=moving. The checks distinguish the carrots by the frame carrot1 in tf, and by the
movement of turtle2.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import hypot, isfinite
from random import Random

from edugrade import Evidence, Failure, Mismatch, Missing, Rubric, Scenario, check
from edugrade.library.arguments import require_declared, require_default
from edugrade.library.deaths import refuse_dead, refuse_gone
from edugrade.library.following import require_arrival, require_driver, require_near, still
from edugrade.library.frames import frames_at_end, numbers, place_in, require_frame, transforms
from edugrade.library.launched import find_processes, require_process
from edugrade.library.movement import length, turtle_track
from edugrade.library.parameters import require_parameter

PACKAGE = 'turtle_tf2_py'
LISTENER = (PACKAGE, 'turtle_tf2_listener')
BROADCASTERS = {'fixed': 'fixed_frame_tf2_broadcaster', 'moving': 'dynamic_frame_tf2_broadcaster'}
LEFT_M = (0.0, 2.0)  # position of the fixed carrot relative to turtle1
SETTLED_S = 15.0
BOUND_M = 0.3
ELSE = 'find out what else drives turtle2 or moves it'
FIRST_TURN_S, TURN_S = 4.0, 2.0  # time when the moving carrot exists; time of one swing from left to right and back
RESTLESS_M = 8.0  # smallest distance that turtle2 drives in 5 s when its goal swings by 20 m
CONDITION = "condition=IfCondition(EqualsSubstitution(LaunchConfiguration('carrot'), '{}'))"


def scenarios(random: Random) -> list[Scenario]:
    """Return a run for each carrot, of about 20 s. The student does not know the exact duration."""
    duration_s = random.randint(38, 46) / 2
    fixed, moving = BROADCASTERS
    return [Scenario(fixed, {}, duration_s, defaults={'carrot': fixed}), Scenario(moving, {'carrot': moving}, duration_s)]


@check(points=1)
def argument_is_declared(run: Evidence) -> None:
    """The launch argument carrot is declared"""
    require_declared(run, 'carrot', 'fixed')


@check(points=1)
def turtles_are_there(run: Evidence) -> None:
    """The launch file starts the two turtles and their broadcasters"""
    require_process(run, *LISTENER)
    for turtle in ('turtle1', 'turtle2'):
        require_frame(run, turtle, 'world', 'include turtle_tf2_demo.launch.py of the package turtle_tf2_py')


@check(needs=[turtles_are_there])
def no_node_dies(run: Evidence) -> None:
    """No node dies before the end"""
    refuse_dead(run)
    refuse_gone(run)


@check(points=2, needs=[no_node_dies])
def one_carrot_at_a_time(run: Evidence) -> None:
    """Each value of carrot starts only its own broadcaster"""
    for name, wanted in BROADCASTERS.items():
        found = [each for executable in BROADCASTERS.values() for each in find_processes(run[name], PACKAGE, executable)]
        started = [str(each.executable) for each in found]
        if started != [wanted]:
            wrong = next((each for each in found if each.executable != wanted), None)
            words, other = run.scenario(name).words, next(key for key in BROADCASTERS if key != name)
            program, only = (wrong.executable, other) if wrong else (wanted, name)
            raise Failure(
                f'{wrong.executable} should not start in the run with {words}'
                if wrong
                else f'{wanted} should start in the run with {words}',
                expected=wanted,
                seen=' and '.join(started) or 'no broadcaster of carrot1',
                where=run.source.own(wrong.origin if wrong else None),
                try_=f'start {program} only with this condition: {CONDITION.format(only)}',
            )


@check(points=1, needs=[argument_is_declared], explained_by=[one_carrot_at_a_time])
def default_is_fixed(run: Evidence) -> None:
    """Without an argument, the carrot is fixed"""
    require_default(run, 'carrot', 'fixed', _starts_fixed)


def _starts_fixed(run: Evidence) -> None:
    """Require the broadcaster of the fixed carrot in each run."""
    for recording in run.values():
        if not find_processes(recording, PACKAGE, BROADCASTERS['fixed']):
            raise Missing(BROADCASTERS['fixed'], where=run.source.place, try_=f'write {CONDITION.format("fixed")} in its Node')


@check(points=1, needs=[one_carrot_at_a_time])
def fixed_carrot_hangs(run: Evidence) -> None:
    """With carrot:=fixed, the frame carrot1 is two metres to the left of turtle1"""
    require_frame(run, 'carrot1', 'turtle1', 'start fixed_frame_tf2_broadcaster of turtle_tf2_py')
    places = [sent.frame.translation[:2] for sent in transforms(run, 'fixed')['carrot1']]
    seen = next((place for place in places if not hypot(place[0] - LEFT_M[0], place[1] - LEFT_M[1]) <= 0.01), None)
    if seen is not None:
        raise Mismatch(
            'the position of carrot1 relative to turtle1',
            numbers(LEFT_M),
            numbers(seen),
            where=run.source.place,
            try_='use fixed_frame_tf2_broadcaster of turtle_tf2_py',
        )


@check(points=1, needs=[one_carrot_at_a_time])
def moving_carrot_swings(run: Evidence) -> None:
    """With carrot:=moving, the frame carrot1 swings from one side of turtle1 to the other"""
    require_frame(run, 'carrot1', 'turtle1', 'start dynamic_frame_tf2_broadcaster of turtle_tf2_py')
    for sides in _sides_in_turns(run):
        if max(sides) - min(sides) >= 5.0:
            continue
        raise Failure(
            'the moving carrot does not move',
            expected='10 m to the left, then 10 m to the right',
            seen=f'{max(sides):.1f} m to the left and {min(sides):.1f} m to the left',
            where=run.source.place,
            try_='use dynamic_frame_tf2_broadcaster of turtle_tf2_py',
        )


@check(points=2, needs=[no_node_dies])
def carrot_is_the_target(run: Evidence) -> None:
    """The listener's parameter target_frame is carrot1"""
    require_parameter(
        run,
        *LISTENER,
        'target_frame',
        dict.fromkeys(run, 'carrot1'),
        "add launch_arguments={'target_frame': 'carrot1'}.items() to IncludeLaunchDescription(...)",
    )


@check(points=2, needs=[fixed_carrot_hangs, carrot_is_the_target])
def fixed_carrot_is_reached(run: Evidence) -> None:
    """turtle2 drives to the fixed carrot and stays there"""
    place = place_in(frames_at_end(run, 'fixed'), 'carrot1', 'world')
    require_near(run, 'fixed', [] if place is None else still(place), '/turtle2', BOUND_M, SETTLED_S, ELSE)
    require_arrival(run, 'fixed', '/turtle2', ELSE)
    require_driver(run, '/turtle2', *LISTENER)


@check(points=1, needs=[moving_carrot_swings, carrot_is_the_target])
def moving_carrot_is_chased(run: Evidence) -> None:
    """turtle2 follows the moving carrot without stopping"""
    require_driver(run, '/turtle2', *LISTENER)
    track = [sample for sample in turtle_track(run['moving'], '/turtle2/pose') if 10.0 <= sample[0] < 15.0]
    if not length(track) >= RESTLESS_M:
        raise Failure(
            'turtle2 does not follow the moving carrot',
            expected=f'a distance of at least {RESTLESS_M:g} m in 5 s',
            seen=f'a distance of {length(track):.2f} m',
            where=run.source.place,
            try_=ELSE,
        )


def _sides_in_turns(run: Evidence) -> Iterator[list[float]]:
    """Yield how far to the left carrot1 was, for each full turn of the moving carrot. NaN counts as 0."""
    sent = transforms(run, 'moving')['carrot1']
    for turn in range(int(FIRST_TURN_S / TURN_S), int(run['moving'].duration_s / TURN_S)):
        during = [item.frame.translation[1] for item in sent if turn * TURN_S <= item.time_s < (turn + 1) * TURN_S]
        yield [side if isfinite(side) else 0.0 for side in during] or [0.0]


RUBRIC = Rubric(
    title='A fixed carrot and a moving one',
    scenarios=scenarios,
    checks=[
        argument_is_declared,
        turtles_are_there,
        no_node_dies,
        one_carrot_at_a_time,
        default_is_fixed,
        fixed_carrot_hangs,
        moving_carrot_swings,
        carrot_is_the_target,
        fixed_carrot_is_reached,
        moving_carrot_is_chased,
    ],
)
