"""The check of lesson 17, your turn: the fleet drives, for each number of followers."""

from __future__ import annotations

from collections.abc import Iterator
from math import atan2, cos, hypot, sin

from edugrade import Evidence, Failure, Rubric, Scenario, check
from edugrade.library.node_graph import require_started

LATEST_S, NEAR_M = 20.0, 0.8
ORDER = 'follow the order of lesson 16: does the turtle exist, is it in the tf tree, does its node find the carrot, and does the node publish?'


def followers(run: Evidence) -> Iterator[tuple[str, int]]:
    """Yield each run with the number of each follower in it."""
    for scenario in run:
        for number in range(2, int(run.scenario(scenario).arguments['count']) + 2):
            yield scenario, number


@check(points=1)
def everybody_is_there(run: Evidence) -> None:
    """Each turtle is in the tf tree at the end"""
    for scenario, number in followers(run):
        if f'turtle{number}' not in run[scenario].frames_at(LATEST_S):
            raise Failure(
                f'turtle{number} is not in the tf tree in the run with {run.scenario(scenario).words}',
                seen=', '.join(sorted(run[scenario].frames_at(LATEST_S))) or 'no frames',
                where=run.source.place,
                try_=ORDER,
            )


@check(points=1)
def everybody_came_after_the_simulator(run: Evidence) -> None:
    """All followers start after the simulator"""
    for scenario in run:
        sim = require_started(run, scenario, '/sim', 'start the simulator with the name sim')
        early = [node.name for node in run[scenario].nodes if node.started_s < sim and 'ros2' not in node.name]
        if early:
            raise Failure(f'{early[0]} starts before the simulator', where=run.source.place, try_='use OnProcessStart, lesson 5')


@check(points=1, needs=[everybody_is_there])
def everybody_knows_its_own_leader(run: Evidence) -> None:
    """The target of each follower is the carrot of the turtle in front of it"""
    for scenario, number in followers(run):
        recording, targets = run[scenario], {}
        for node in dict.fromkeys(node.name for node in recording.nodes):
            found = recording.parameters(node)
            if 'me' in found and 'target' in found:
                targets[found['me'].value] = found['target'].value
        wanted = f'carrot_turtle{number - 1}'
        if targets.get(f'turtle{number}') != wanted:
            raise Failure(
                f'turtle{number} does not follow turtle{number - 1}',
                expected=f'the target {wanted}',
                seen=str(targets.get(f'turtle{number}', 'no target')),
                where=run.source.place,
                try_='check which leader fleet.launch.py passes to the include',
            )


@check(points=2, needs=[everybody_knows_its_own_leader])
def everybody_is_near_its_carrot(run: Evidence) -> None:
    """After 20 s each follower is within 0.8 m of its carrot"""
    for scenario, number in followers(run):
        frames = run[scenario].frames_at(LATEST_S)
        leader, me = frames.get(f'turtle{number - 1}'), frames[f'turtle{number}']
        if leader is None:
            raise Failure(f'turtle{number - 1} is not in the tf tree', where=run.source.place, try_=ORDER)
        (x, y, _), (*_, z, w) = leader.translation, leader.rotation
        yaw = 2 * atan2(z, w)
        away = hypot(x - cos(yaw) - me.translation[0], y - sin(yaw) - me.translation[1])
        if not away <= NEAR_M:
            raise Failure(
                f'turtle{number} is too far from its carrot in the run with {run.scenario(scenario).words}',
                expected=f'at most {NEAR_M:g} m',
                seen=f'{away:.2f} m',
                where=run.source.place,
                try_=ORDER,
            )


RUBRIC = Rubric(
    title='The fleet drives',
    of='my_ws/src/fleet/launch/fleet.launch.py',
    scenarios=lambda random: [Scenario(f'count_{count}', {'count': str(count)}, LATEST_S) for count in (1, 2, 3)],
    checks=[everybody_is_there, everybody_came_after_the_simulator, everybody_knows_its_own_leader, everybody_is_near_its_carrot],
)
