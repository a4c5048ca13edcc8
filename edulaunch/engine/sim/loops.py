"""Which asyncio loop runs in a thread, taken away for a while and given back.

Simulated time passes inside of loops: that of a notebook, that of a program. Whatever runs meanwhile has to find no loop.
"""

from __future__ import annotations

import sys
from asyncio import AbstractEventLoop, Task, events, tasks
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from typing import Any

Aside = tuple['AbstractEventLoop | None', 'Task[Any] | None']

TASKS_ARE_THE_THREADS = sys.version_info >= (3, 14)
"""Before, each loop had a current task of its own, which was in nobody's way."""
NOTHING: Aside = (None, None)


def set_aside() -> Aside:
    """From now on no loop runs here; returns what :func:`put_back` wants."""
    loop = events._get_running_loop()
    task = tasks._swap_current_task(loop, None) if TASKS_ARE_THE_THREADS and loop is not None else None  # type: ignore[attr-defined]
    events._set_running_loop(None)
    return loop, task


def put_back(aside: Aside) -> None:
    """The loop runs again, in the middle of the task that it was in."""
    loop, task = aside
    events._set_running_loop(loop)
    if task is not None:
        tasks._swap_current_task(loop, task)  # type: ignore[attr-defined]


def cancel_all_tasks(loop: AbstractEventLoop) -> None:
    """Cancel what is left on a loop that stands still, and run it until all of it has ended."""
    left = tasks.all_tasks(loop)
    for task in left:
        task.cancel()
    if left:
        loop.run_until_complete(_all_ended(left))


async def _all_ended(left: Iterable[Task[Any]]) -> None:
    await tasks.gather(*left, return_exceptions=True)


@contextmanager
def outer_loop_set_aside() -> Iterator[None]:
    """Let simulated programs run as if no loop ran around them, and give the notebook its loop back afterwards.

    A launch that continues to run is left in the middle of its own loop. Without this function, the kernel would take that loop,
    or none, for the running one.
    """
    hooks, outer = sys.get_asyncgen_hooks(), set_aside()
    try:
        yield
    finally:
        put_back(outer)
        sys.set_asyncgen_hooks(*hooks)
