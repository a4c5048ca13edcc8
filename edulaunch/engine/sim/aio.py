"""An asyncio event loop with a simulated clock.

While the loop waits for its next timer, its task is parked and other programs run. Launch runs on this loop.
"""

from __future__ import annotations

import asyncio
from asyncio import base_events
from collections.abc import Callable
from typing import Any

from edulaunch.engine.sim.loops import NOTHING, put_back, set_aside
from edulaunch.engine.sim.task import Task, TaskKilled, current_task


class _Turns:
    """The selector of the event loop. Instead of waiting for files, it ends the turn of the task."""

    def __init__(self, loop: SimulatedEventLoop) -> None:
        self._loop = loop

    def select(self, timeout: float | None) -> list[Any]:
        task = self._loop.task
        if timeout is None:
            task.park()
        elif timeout > 0:
            task.park(task.sim.now_ns + max(1, round(timeout * 1e9)))
        return []


class SimulatedEventLoop(base_events.BaseEventLoop):
    """asyncio's own event loop with simulated time: `time()` returns the seconds since the start of the simulation."""

    def __init__(self, task: Task) -> None:
        super().__init__()
        self.task = task
        self._selector = _Turns(self)
        self._clock_resolution = 1e-9

    def __del__(self, _warn: object = None) -> None:
        """Print no warning about an unclosed loop, because the loop does not use a resource of the operating system."""

    def time(self) -> float:
        """Return the simulated seconds since the start of the simulation."""
        return self.task.sim.elapsed_s

    def run_forever(self) -> None:
        """Run the loop in the running task, until `stop` is called.

        Meanwhile, a loop that runs around this one (such as a notebook's loop) is set aside.
        """
        self.task = current_task()
        outer, outer_loop = set_aside(), self.task.loop
        self.task.loop = self
        try:
            super().run_forever()
        finally:
            self.task.loop = outer_loop
            put_back(outer)

    def _check_running(self) -> None:
        """Raise RuntimeError if this loop runs already. Another loop may run around it, because `run_forever` sets that loop
        aside.
        """
        if self.is_running():
            raise RuntimeError('This event loop is already running')

    def call_exception_handler(self, context: dict[str, Any]) -> None:
        """Handle an exception as asyncio does, except that the end of a program is not an error of the interrupted callback."""
        if not isinstance(context.get('exception'), TaskKilled):
            super().call_exception_handler(context)

    def step_aside(self, switch: Callable[[], object]) -> None:
        """End the turn with this loop set aside, so that other programs may run their own loops.

        :param switch: the function that switches to the hub.
        """
        mine = set_aside()
        try:
            switch()
        finally:
            put_back(mine if self.is_running() else NOTHING)

    def _process_events(self, event_list: list[Any]) -> None:
        """Do nothing, because there are no file events."""

    def _write_to_self(self) -> None:
        self.task.wake()


def new_event_loop() -> asyncio.AbstractEventLoop:
    """Return a new event loop for the simulation of the running task."""
    return SimulatedEventLoop(current_task())
