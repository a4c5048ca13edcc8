"""The event loop that processes are executed on."""
from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from asyncio import AbstractEventLoop


def get_loop() -> AbstractEventLoop:
    """The asyncio loop of the running task; made, on simulated time, when there is none yet or it is closed.
    """
    from edulaunch.processes import current_process
    from edulaunch.sim.aio import new_event_loop
    state = current_process().state
    loop: AbstractEventLoop | None = state.get('osrf_pycommon.loop')
    if loop is None or loop.is_closed():
        loop = state['osrf_pycommon.loop'] = new_event_loop()
    return loop
