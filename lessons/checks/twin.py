"""The check of lesson 5: a handler that watches the action that runs."""

from __future__ import annotations

from edugrade import Evidence, Failure, Rubric, Scenario, check
from edugrade.library.identity import nodes_of


@check(points=1)
def the_line_is_written_once(run: Evidence) -> None:
    """Launch prints the line once"""
    said, in_vain = (sum('the sim runs' in line.text for line in run[name].output) for name in ('run', 'without'))
    if said == 1 and in_vain:
        raise Failure(
            'the line "the sim runs" appears although no simulator runs',
            seen='the line comes without an event',
            where=run.source.place,
            try_='keep RegisterEventHandler with OnProcessStart, and let it watch the simulator',
        )
    if said != 1:
        raise Failure(
            'the line "the sim runs" does not appear exactly once',
            seen=f'{said} times',
            where=run.source.place,
            try_=['check which action the handler watches', 'each call of simulator() creates a new action', 'sim = simulator()'],
        )


@check(points=1)
def there_is_one_simulator(run: Evidence) -> None:
    """There is exactly one simulator"""
    number = len(nodes_of(run.first, 'turtlesim', 'turtlesim_node'))
    if number != 1:
        raise Failure(
            'the number of simulators is not one',
            seen=f'{number} nodes',
            where=run.source.place,
            try_='check which action is in the list',
        )


RUBRIC = Rubric(
    title='The action that runs',
    of='my_launch/twin.launch.py',
    scenarios=lambda random: [Scenario('run', {}, 1.0), Scenario('without', {}, 1.0, fails=['turtlesim_node'])],
    checks=[the_line_is_written_once, there_is_one_simulator],
)
