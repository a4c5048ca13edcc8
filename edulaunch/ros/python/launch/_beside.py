"""Runs a launch in a plain script next to other running code: real threads, or other tasks of an asyncio loop.

Without such code, simulated time runs as fast as possible. Other code in real time may call the launch service, such as a
`threading.Timer` that shuts the launch down. With such code, simulated time follows real time in slices.
"""

from __future__ import annotations

import sys
import threading
import time
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from edulaunch.errors import SimulationError

from ._engine import is_plain_script

if TYPE_CHECKING:
    import asyncio

SLICE_S = 0.01


class StartedThreads:
    """Checks whether the script has started threads since this object was created, and whether they are running."""

    def __init__(self) -> None:
        self._before = {thread.ident for thread in threading.enumerate()} if is_plain_script() else None

    def has_come(self) -> bool:
        """Return whether a thread is running that the script has started since this object was created."""
        before = self._before
        if before is None:
            return False
        new = [thread for thread in threading.enumerate() if thread.ident not in before]
        if not new:
            return False
        from edulaunch.engine.processes.real import READER_NAME

        return any(not thread.name.startswith(READER_NAME) for thread in new)


def run_beside_threads(loop: asyncio.AbstractEventLoop, task: asyncio.Task[int], threads: StartedThreads) -> int:
    """Run the loop until the task is done, and return the result of the task.

    :raises SimulationError: when no code can end the wait of the task.
    """
    while not task.done():
        if not _has_run_alone(loop, task, threads.has_come):
            time.sleep(_run_slice(loop))
    return task.result()


async def run_beside_tasks(loop: asyncio.AbstractEventLoop, task: asyncio.Task[int], threads: StartedThreads) -> int:
    """Run a simulated loop until its task is done, and return the result of the task.

    Meanwhile, the loop that awaits this coroutine runs its other tasks. In a notebook, the simulation counts as alone,
    because the other tasks of the kernel do not belong to the student.

    :raises SimulationError: when no code can end the wait of the task.
    """
    import asyncio

    outer: Any = asyncio.get_running_loop()

    def has_others() -> bool:
        others = len(asyncio.all_tasks(outer)) > 1 or bool(getattr(outer, '_scheduled', False))
        return (others and not _is_notebook()) or threads.has_come()

    try:
        while not task.done():
            if not _has_run_alone(loop, task, has_others):
                await asyncio.sleep(_run_slice(loop))
    except asyncio.CancelledError:
        task.cancel()
        loop.run_until_complete(task)
    return task.result()


def _is_notebook() -> bool:
    """Return whether a kernel runs the cells. An IPython object that the program created without a kernel does not count."""
    shell: Any = sys.modules.get('IPython')
    return shell is not None and hasattr(shell.get_ipython(), 'kernel')


def _has_run_alone(loop: asyncio.AbstractEventLoop, task: asyncio.Task[int], has_others: Callable[[], bool]) -> bool:
    """Run the task to its end if no other code runs, and return whether this was possible."""
    if has_others():
        return False
    try:
        loop.run_until_complete(task)
    except SimulationError:
        if task.done() or not has_others():
            raise
        return False
    except BaseException:
        if task.done() and not task.cancelled():
            task.exception()  # the function that ends the program reports it, so asyncio need not report it again
        raise
    return True


def _run_slice(loop: asyncio.AbstractEventLoop) -> float:
    """Run the loop for a slice of simulated time. Return the remaining real time of the slice in seconds."""
    began = time.monotonic()
    end = loop.call_later(SLICE_S, loop.stop)
    try:
        loop.run_forever()
    finally:
        end.cancel()
    return max(0.0, SLICE_S - (time.monotonic() - began))
