"""Lesson 5: a handler that watches the action that runs."""

from __future__ import annotations

from edugrade import Evidence, Failure, Rubric, Scenario, check


@check(points=1)
def the_line_is_written_once(run: Evidence) -> None:
    """The line is written, once"""
    said = sum('the sim runs' in line.text for line in run.first.output)
    if said != 1:
        raise Failure(
            'the line "the sim runs" is not written once',
            seen=f'{said} times',
            where=run.source.place,
            try_=['an action that is made twice', 'simulator() makes a new one each time that it is called', 'sim = simulator()'],
        )


@check(points=1)
def there_is_one_simulator(run: Evidence) -> None:
    """There is one simulator"""
    if len(run.first.nodes) != 1:
        raise Failure(
            'there is not one simulator',
            seen=f'{len(run.first.nodes)} nodes',
            where=run.source.place,
            try_='which action stands in the list?',
        )


RUBRIC = Rubric(
    title='The action that runs',
    of='my_launch/twin.launch.py',
    scenarios=lambda random: [Scenario('run', {}, 1.0)],
    checks=[the_line_is_written_once, there_is_one_simulator],
)
