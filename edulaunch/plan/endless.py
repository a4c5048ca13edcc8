"""A launch file that goes on for ever: a timer that starts itself again, a `while True`, a handler that feeds itself."""

from __future__ import annotations

import gc
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from edulaunch.sim.simulation import Simulation

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
