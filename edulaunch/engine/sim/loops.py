"""Sets the running asyncio loop of a thread aside for a while.

Simulated time passes inside loops, such as the loop of a notebook or of a program. Code that runs during this time must find no
running loop.
"""

from __future__ import annotations

import sys
from asyncio import AbstractEventLoop, Task, events, tasks
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from typing import Any

Aside = tuple['AbstractEventLoop | None', 'Task[Any] | None']

TASKS_ARE_THE_THREADS = sys.version_info >= (3, 14)
"""In older versions, each loop has its own current task, so nothing needs to be set aside."""
NOTHING: Aside = (None, None)


def set_aside() -> Aside:
    """Set the running loop of this thread aside, and return the argument for :func:`put_back`."""
    loop = events._get_running_loop()
    task = tasks._swap_current_task(loop, None) if TASKS_ARE_THE_THREADS and loop is not None else None  # type: ignore[attr-defined]
    events._set_running_loop(None)
    return loop, task


def put_back(aside: Aside) -> None:
    """Make a loop the running loop again, in the middle of its current task.

    :param aside: the result of :func:`set_aside`.
    """
    loop, task = aside
    events._set_running_loop(loop)
    if task is not None:
        tasks._swap_current_task(loop, task)  # type: ignore[attr-defined]


def cancel_all_tasks(loop: AbstractEventLoop) -> None:
    """Cancel the remaining tasks of a stopped loop, and run it until they have ended."""
    left = tasks.all_tasks(loop)
    for task in left:
        task.cancel()
    if left:
        loop.run_until_complete(_all_ended(left))


async def _all_ended(left: Iterable[Task[Any]]) -> None:
    await tasks.gather(*left, return_exceptions=True)


@contextmanager
def outer_loop_set_aside() -> Iterator[None]:
    """Run simulated programs as if no loop ran around them, and restore the outer loop (such as a notebook's) afterwards.

    A launch that continues to run stays in the middle of its own loop. Without this context manager, Jupyter would find that
    loop, or no loop, as the running one.
    """
    hooks, outer = sys.get_asyncgen_hooks(), set_aside()
    try:
        yield
    finally:
        put_back(outer)
        sys.set_asyncgen_hooks(*hooks)
