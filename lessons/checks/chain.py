"""The check of lesson 5, your turn: start programs in order, and end everything."""

from __future__ import annotations

from edugrade import Evidence, Failure, Rubric, Scenario, check
from edugrade.library.close import require_close
from edugrade.library.identity import nodes_of
from edugrade.library.node_graph import require_started

END_S = 8.0


def refuse_without_simulator(run: Evidence, package: str, executable: str, advice: str) -> None:
    if nodes_of(run['without'], package, executable):
        raise Failure(
            f'{executable} starts although the simulator does not start',
            expected='it waits for the start of the simulator',
            seen='it starts after a time, or at once',
            where=run.source.place,
            try_=advice,
        )


@check(points=1)
def square_starts_after_the_simulator(run: Evidence) -> None:
    """draw_square starts when the simulator has started"""
    advice = 'use RegisterEventHandler with OnProcessStart, section 5.2'
    sim = require_started(run, 'run', '/sim', advice)
    if require_started(run, 'run', '/draw_square', advice) < sim:
        raise Failure('draw_square starts before the simulator', where=run.source.place, try_=advice)
    refuse_without_simulator(run, 'turtlesim', 'draw_square', advice)


@check(points=1, needs=[square_starts_after_the_simulator])
def copy_comes_three_seconds_later(run: Evidence) -> None:
    """A mimic called copy starts 3 s after draw_square"""
    advice = 'put a TimerAction into the list of a handler, section 5.1'
    late = require_started(run, 'run', '/copy', advice) - require_started(run, 'run', '/draw_square', advice)
    refuse_without_simulator(run, 'turtlesim', 'mimic', advice)
    require_close(run, 'run', 'the delay between draw_square and copy in s', late, 3.0, 0.2, try_=advice)


@check(points=1, needs=[square_starts_after_the_simulator])
def its_end_is_the_end_of_all(run: Evidence) -> None:
    """When draw_square ends, everything ends"""
    launch = run['run'].processes[0]
    if launch.name == 'launch' and launch.ended_s is None:
        raise Failure(
            'no action ends everything when draw_square ends',
            expected='an action that ends the launch when draw_square ends',
            seen=f'draw_square ends at {END_S:g} s, and the launch continues',
            where=run.source.place,
            try_=[
                'add an action that ends everything',
                'section 5.3 shows the action, and where you can use it',
                'write on_exit=[Shutdown()] in the Node',
            ],
        )
    if launch.ended_s is not None and launch.ended_s < END_S:
        raise Failure(
            'the launch ends before draw_square',
            expected=f'it ends after {END_S:g} s, when draw_square ends',
            seen=f'it ends at {launch.ended_s:.2f} s',
            where=run.source.place,
            try_='connect the end of the launch to the end of draw_square, section 5.3',
        )


RUBRIC = Rubric(
    title='One after the other',
    of='my_launch/careful.launch.py',
    ended='draw_square',
    scenarios=lambda random: [Scenario('run', {}, END_S), Scenario('without', {}, END_S, fails=['turtlesim_node'])],
    checks=[square_starts_after_the_simulator, copy_comes_three_seconds_later, its_end_is_the_end_of_all],
)
