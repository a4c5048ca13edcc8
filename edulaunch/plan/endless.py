"""A launch file that goes on for ever: a timer that starts itself again, a `while True`, a handler that feeds itself."""

from __future__ import annotations

import gc
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from edulaunch.processes.watchdog import RunawayProgram
    from edulaunch.sim.simulation import Simulation

TURN_LIMIT_S = 2.0
"""Seconds of the processor's time that the code of a launch file may take without coming on; see `Watchdog`."""
MOST_INSTANTS = 2_000
MOST_STEPS = 500_000
"""So often may simulated time advance, and so much may be done, before something must end."""
STEPS_BETWEEN_COLLECTIONS = 20_000
"""A plan is made without the garbage collector, which takes half of the time of a large one."""
MOST_REACTIONS = 20_000
"""So often may event handlers give actions: events that follow from events are all handled in one step."""


def run_to_rest(sim: Simulation) -> str | None:
    """Go on until there is nothing left to do; what to say when that does not happen, else None."""
    instants, now = 0, sim.now_ns
    for step in range(MOST_STEPS):
        if step % STEPS_BETWEEN_COLLECTIONS == STEPS_BETWEEN_COLLECTIONS - 1:
            gc.collect()
        if not sim.step():
            return None
        if sim.now_ns != now:
            instants, now = instants + 1, sim.now_ns
            if instants > MOST_INSTANTS:
                break
    return still_busy(sim)


def still_busy(sim: Simulation) -> str:
    """What to say then."""
    return f'the launch file goes on without end: after {sim.elapsed_s:g} simulated seconds it still does something'


def runaway_error(error: RunawayProgram) -> dict[str, str | None]:
    """The error of a plan whose launch file was stopped in a loop, with the line at which it was."""
    from traceback import walk_tb

    from launch._failure import is_students

    places = [f'{frame.f_code.co_filename}:{line}' for frame, line in walk_tb(error.__traceback__)]
    own = [place for place in places if is_students(place.rpartition(':')[0])]
    return {
        'type': 'RunawayProgramError',
        'text': 'the launch file never came to its end and was stopped',
        'help': 'look for a loop that does not end: a launch file only says what to start',
        'origin': own[-1] if own else None,
        'stage': 'load',
    }
