"""The rubric of the convoy: a row of turtles, each of which follows the turtle in front of it.

The positions of the turtles in the simulator decide, for any number of followers. In the second run, the grader turns turtle1, so
that a follower on a fixed path loses it.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import cos, hypot, sin
from random import Random
from typing import TYPE_CHECKING

from edugrade import Evidence, Failure, Missing, Rubric, Scenario, check
from edugrade.library.deaths import refuse_dead, refuse_gone
from edugrade.library.following import driven_track, require_driver
from edugrade.library.frames import transforms
from edugrade.library.identity import nodes_of, processes_of
from edugrade.library.movement import length, since
from edugrade.library.node_graph import require_started
from edugrade.library.parameters import parameter_of

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording
    from edulaunch.engine.recording.records import NodeRecord

FOLLOWER, SIMULATOR = ('convoy', 'follower'), ('turtlesim', 'turtlesim_node')
WITHOUT = 'without'  # the run in which the start of the simulator fails
LATEST_S, NEAR_M, BEHIND_M = 20.0, 0.8, 1.0
MIDDLE_M, RADIUS_M, TURN_RAD_S = 5.544, 2.5, 0.4  # the start of turtle1, and its circle
ORDER = [
    'check each step from the new turtle to its movement',
    'check, in this order, whether the turtle exists, is in the tf tree, finds the carrot, and drives',
]
CHOICE = [
    'check the arguments of the included launch file',
    'compare the argument leader of each follower with the turtle in front of it',
    'pass turtle1 as the leader of turtle2, turtle2 as the leader of turtle3, and so on',
]
PARAMETERS = [
    'check the parameters of the Node',
    'set the parameters me and target of the node follower',
    "write parameters=[{'me': me, 'target': ['carrot_', leader]}]",
]


def scenarios(random: Random) -> list[Scenario]:
    """Return a run with one follower, a run with several, and a run in which the simulator does not start."""
    several = Scenario('several', {'count': str(random.randint(2, 3))}, LATEST_S, turned={'/turtle1': _turn(random)})
    return [Scenario('one', {'count': '1'}, LATEST_S), several, Scenario(WITHOUT, {'count': '1'}, 3.0, fails=[SIMULATOR[1]])]


def _turn(random: Random) -> tuple[float, float]:
    """Choose when the grader turns turtle1, and by which angle, so that its next circle is within the walls."""
    while True:
        time_s, angle = round(random.uniform(4.0, 9.0), 2), round(random.uniform(0.8, 2.5) * random.choice([-1, 1]), 2)
        before, after = TURN_RAD_S * time_s, TURN_RAD_S * time_s + angle
        x = MIDDLE_M + RADIUS_M * (sin(before) - sin(after))
        y = MIDDLE_M + RADIUS_M * (1.0 - cos(before) + cos(after))
        if all(RADIUS_M + 1.0 < place < 2 * MIDDLE_M - RADIUS_M - 1.0 for place in (x, y)):
            return time_s, angle


def driven(run: Evidence) -> Evidence:
    """Return the evidence of the runs in which the simulator starts."""
    return run.only([scenario for scenario in run if scenario != WITHOUT])


def followers(run: Evidence) -> Iterator[tuple[str, int]]:
    """Yield each run with the number of each turtle that follows in it."""
    for scenario in driven(run):
        for number in range(2, int(run.scenario(scenario).arguments['count']) + 2):
            yield scenario, number


@check(points=1)
def no_node_dies(run: Evidence) -> None:
    """No node dies before the end"""
    refuse_dead(driven(run))
    refuse_gone(driven(run))


@check(points=2, needs=[no_node_dies])
def everybody_is_there(run: Evidence) -> None:
    """The launch argument count sets the number of followers"""
    for scenario in driven(run):
        wanted = {f'turtle{number}' for where, number in followers(run) if where == scenario} | {'turtle1'}
        poses = [topic for topic in run[scenario].topics.values() if topic.count and topic.name.endswith('/pose')]
        seen = {topic.name.split('/')[1] for topic in poses if topic.name.startswith('/turtle')}
        if seen != wanted:
            words, turtles = run.scenario(scenario).words, ' and '.join(sorted(wanted - {'turtle1'}))
            wrong = ' and '.join(sorted(wanted - seen or seen - wanted))
            raise Failure(
                f'{wrong} is missing in the run with {words}'
                if wanted - seen
                else f'{wrong} should not exist in the run with {words}',
                expected=', '.join(sorted(wanted)),
                seen=', '.join(sorted(seen)),
                where=run.source.place_in('convoy.launch.py', 'IncludeLaunchDescription[(]'),
                try_=f'check the conditions of the included follower.launch.py: with {words}, include it only for {turtles}',
            )


@check(points=2, needs=[no_node_dies])
def everybody_came_after_the_simulator(run: Evidence) -> None:
    """No follower starts before the simulator"""
    if not any(_of_followers(run[scenario]) for scenario in driven(run)):
        raise Missing(
            'a follower',
            seen='no node of the program follower',
            where=run.source.place,
            try_='include follower.launch.py for each follower',
        )
    for scenario, recording in run.items():
        early, is_without = _of_followers(recording), scenario == WITHOUT
        if not is_without:
            sim = require_started(run, scenario, '/sim', 'give the simulator the name sim', 'turtlesim')
            early = [node for node in early if node.started_s < sim]
        calls = [call for call in recording.service_calls if call.service == '/spawn' and not call.served]
        if early or not (is_without or (not calls and _after(run, scenario))):
            name = early[0].name if early else 'a follower'
            raise Failure(
                f'{name} does not wait for the simulator',
                expected='each follower starts after the simulator',
                seen=f'{name} starts in a run without the simulator' if is_without else f'{name} starts before the simulator',
                where=run.source.place,
                try_=[
                    'check the event handler',
                    'find in lesson 5 the event that launch creates when a process has started',
                    'write OnProcessStart(target_action=sim, on_start=row)',
                ],
            )


def _of_followers(recording: Recording) -> list[NodeRecord]:
    """Return the nodes of the student's program, whatever their names, and the nodes with the names of carrots."""
    own = set(nodes_of(recording, *FOLLOWER))
    return [node for at, node in enumerate(recording.nodes) if at in own or node.name.startswith('/carrot_of')]


def _after(run: Evidence, scenario: str) -> bool:
    """Return whether the process of the simulator started before the processes of the followers."""
    own, sims = (processes_of(run[scenario], *program) for program in (FOLLOWER, SIMULATOR))
    return not own or (bool(sims) and sims[0] < own[0])


@check(points=3, needs=[everybody_is_there])
def each_knows_its_own_leader(run: Evidence) -> None:
    """Each follower drives to the carrot of the turtle in front of it"""
    for scenario, number in followers(run):
        recording, targets = run[scenario], {}
        for position in nodes_of(recording, *FOLLOWER):
            me, target = (parameter_of(recording, position, name) for name in ('me', 'target'))
            if me is not None and target is not None:
                targets[me.value] = target.value
        target = str(targets.get(f'turtle{number}', 'no target'))
        if target != f'carrot_turtle{number - 1}':
            # convoy.launch.py chooses the leader, and follower.launch.py passes it on
            is_passed_on = target.startswith('carrot_turtle') and len(targets) == len(nodes_of(recording, *FOLLOWER))
            file, word = ('convoy.launch.py', 'leader') if is_passed_on else ('follower.launch.py', 'target')
            raise Failure(
                f'turtle{number} does not follow turtle{number - 1}',
                expected=f'the target carrot_turtle{number - 1}',
                seen=target,
                where=run.source.place_in(file, f'[\'"]{word}[\'"]'),
                try_=CHOICE if is_passed_on else PARAMETERS,
            )


@check(points=4, needs=[each_knows_its_own_leader])
def each_is_near_its_carrot(run: Evidence) -> None:
    """After 20 s, each follower has driven and is within 0.8 m of its carrot"""
    for scenario, number in followers(run):
        require_driver(run.only([scenario]), f'/turtle{number}', FOLLOWER[0])
        carrot = next(iter(transforms(run, scenario).get(f'carrot_turtle{number - 1}', ())[-1:]), None)
        is_lost = carrot is not None and not abs(carrot.frame.translation[0] + BEHIND_M) <= 0.01
        *_, (_, x, y, theta) = run[scenario].series(f'/turtle{number - 1}/pose', 'x', 'y', 'theta')
        track = driven_track(run, scenario, f'/turtle{number}')
        away = hypot(x - BEHIND_M * cos(theta) - track[-1][1], y - BEHIND_M * sin(theta) - track[-1][2])
        if not away <= NEAR_M or not length(since(track, 2.0)) >= 2.0:
            raise Failure(
                f'turtle{number} is not at its carrot in the run with {run.scenario(scenario).words}',
                expected=f'at most {NEAR_M:g} m from its carrot, {BEHIND_M:g} m behind turtle{number - 1}',
                seen=f'{away:.2f} m from its carrot, after a drive of {length(track):.1f} m',
                where=run.source.place,
                try_=f'set the x of the frame carrot_turtle{number - 1} to {-BEHIND_M:g}' if is_lost else ORDER,
            )


RUBRIC = Rubric(
    title='A convoy',
    scenarios=scenarios,
    checks=[
        no_node_dies,
        everybody_is_there,
        everybody_came_after_the_simulator,
        each_knows_its_own_leader,
        each_is_near_its_carrot,
    ],
)
