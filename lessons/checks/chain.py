"""The check of lesson 5, your turn: start programs in order, and end everything."""

from __future__ import annotations

import re

from edugrade import Evidence, Failure, Rubric, Scenario, check
from edugrade.library.close import require_close
from edugrade.library.node_graph import require_started


@check(points=1)
def square_starts_after_the_simulator(run: Evidence) -> None:
    """draw_square starts when the simulator has started"""
    advice = 'use RegisterEventHandler with OnProcessStart, section 5.2'
    sim = require_started(run, 'run', '/sim', advice)
    if require_started(run, 'run', '/draw_square', advice) < sim:
        raise Failure('draw_square starts before the simulator', where=run.source.place, try_=advice)


@check(points=1, needs=[square_starts_after_the_simulator])
def copy_comes_three_seconds_later(run: Evidence) -> None:
    """A mimic called copy starts 3 s after draw_square"""
    advice = 'put a TimerAction into the list of a handler, section 5.1'
    late = require_started(run, 'run', '/copy', advice) - require_started(run, 'run', '/draw_square', advice)
    require_close(run, 'run', 'the delay between draw_square and copy in s', late, 3.0, 0.2, try_=advice)


@check(points=1, needs=[square_starts_after_the_simulator])
def its_end_is_the_end_of_all(run: Evidence) -> None:
    """When draw_square ends, everything ends"""
    if not any(re.search(r'^[^#\n]*\bShutdown\(', text, re.MULTILINE) for text in run.source.texts().values()):
        raise Failure(
            'no action in the file ends everything',
            expected='an action that ends the launch when draw_square ends',
            where=run.source.place,
            try_=[
                'add an action that ends everything',
                'section 5.3 shows the action, and where you can use it',
                'write on_exit=[Shutdown()] in the Node',
            ],
        )


RUBRIC = Rubric(
    title='One after the other',
    of='my_launch/careful.launch.py',
    scenarios=lambda random: [Scenario('run', {}, 8.0)],
    checks=[square_starts_after_the_simulator, copy_comes_three_seconds_later, its_end_is_the_end_of_all],
)
