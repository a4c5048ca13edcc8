"""The check of lesson 13, your turn: a third world, whose turtle copies the second one."""

from __future__ import annotations

from math import hypot

from edugrade import Evidence, Failure, Rubric, Scenario, check
from edugrade.library.following import require_copy
from edugrade.library.movement import turtle_track
from edugrade.library.node_graph import require_node

SECOND, THIRD = '/turtlesim2/turtle1', '/turtlesim3/turtle1'


@check(points=1)
def there_is_a_third_world(run: Evidence) -> None:
    """There is a world /turtlesim3/sim"""
    require_node(run, '/turtlesim3/sim', 'turtlesim', 'add a group with a namespace, as for turtlesim2', 'turtlesim_node')


@check(points=1)
def there_are_two_mimics(run: Evidence) -> None:
    """There are two mimics with different names"""
    found = [node.name for node in run.first.nodes if node.name.endswith('/mimic')]
    if len(set(found)) != 2 or len(found) != 2:
        raise Failure(
            'there are not two mimics',
            seen=', '.join(found) or 'none',
            where=run.source.place,
            try_='push a namespace there as well',
        )


@check(points=1, needs=[there_is_a_third_world, there_are_two_mimics])
def one_leads_from_the_second_to_the_third(run: Evidence) -> None:
    """One mimic subscribes to the turtle of the second world, and publishes to that of the third"""
    ends = {
        node.name: ([name for name, _ in node.subscriptions], [name for name, _ in node.publishers])
        for node in run.first.nodes
        if node.name.endswith('/mimic')
    }
    if not any(f'{SECOND}/pose' in heard and f'{THIRD}/cmd_vel' in spoken for heard, spoken in ends.values()):
        seen = '\n'.join(
            f'{name}: {", ".join(each for each in heard if each.endswith("/pose"))} -> '
            f'{", ".join(each for each in spoken if each.endswith("/cmd_vel"))}'
            for name, (heard, spoken) in ends.items()
        )
        raise Failure(
            'no mimic connects the second world to the third',
            expected=f'{SECOND}/pose -> {THIRD}/cmd_vel',
            seen=seen,
            where=run.source.place,
            try_=['check the arguments of an include', 'write leader and copier as full names', "leader='/turtlesim2/turtle1'"],
        )


@check(points=1, needs=[one_leads_from_the_second_to_the_third])
def it_copies_the_second(run: Evidence) -> None:
    """The turtle of the third world copies that of the second"""
    require_copy(run, SECOND, THIRD, 'check which other node sends it commands')
    (*_, x, y), (*_, u, v) = (turtle_track(run.first, f'{name}/pose')[-1] for name in (SECOND, THIRD))
    if not hypot(u - x, v - y) < 0.2:
        raise Failure(
            'the two turtles end in different places',
            expected=f'{x:.2f} {y:.2f}',
            seen=f'{u:.2f} {v:.2f}',
            where=run.source.place,
        )


RUBRIC = Rubric(
    title='A third world',
    of='my_ws/src/launch_tutorial/launch/launch_turtlesim.launch.py',
    scenarios=lambda random: [Scenario('run', {}, 8.0)],
    checks=[there_is_a_third_world, there_are_two_mimics, one_leads_from_the_second_to_the_third, it_copies_the_second],
)
