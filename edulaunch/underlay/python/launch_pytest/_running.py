"""Running the parts of a test in simulated time, and telling what waits for ever."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable
from typing import Any

import pytest

from edulaunch.errors import SimulationError
from edulaunch.processes.current import current_process
from edulaunch.sim.task import Task

LONGEST_WAIT_S = 600.0


def run_until_complete(loop: asyncio.AbstractEventLoop, awaitable: Awaitable[Any], problem: str) -> Any:
    """Run the loop until something is done; gives its result.

    :param problem: what to say when it never is: it is waited for ten minutes of simulated time.
    :raises: what the awaitable raises; pytest's failure when it is still not done then.
    """
    __tracebackhide__ = True
    future = asyncio.ensure_future(awaitable, loop=loop)
    began = current_process().sim.elapsed_s
    limit = loop.call_later(LONGEST_WAIT_S, loop.stop)
    try:
        loop.run_until_complete(_settled(future))
    except (RuntimeError, SimulationError):
        if future.done():
            raise
        future.cancel()
        loop.run_until_complete(_settled(future))
        waited = current_process().sim.elapsed_s - began
        pytest.fail(
            f'{problem}: it was still waiting after {waited:.1f} s of simulated time\n'
            '  help: give waits a timeout, such as wait_for_exit(launch_context, action, timeout=10)',
            pytrace=False,
        )
    finally:
        limit.cancel()
    return future.result()


def _set(done: asyncio.Future[None]) -> None:
    if not done.done():
        done.set_result(None)


async def _settled(future: asyncio.Future[Any]) -> None:
    """Wait for a future without taking over what it raises: asyncio ends the loop when that is no `Exception`."""
    await asyncio.wait([future])


def run_beside(loop: asyncio.AbstractEventLoop, body: Callable[[], Any]) -> Any:
    """Run blocking code beside the loop, as upstream does in a thread; gives its result.

    :raises: what the code raises.
    """
    __tracebackhide__ = True
    process = current_process()
    done = loop.create_future()
    task = Task(process.sim, body, name='test', owner=process)
    task.add_done_callback(lambda _: loop.call_soon_threadsafe(_set, done))
    task.start()
    try:
        run_until_complete(loop, done, 'the test did not come to its end')
    finally:
        if not task.finished:
            task.kill()
            process.sim.run(process.sim.now_ns)
    if task.exception is not None:
        raise task.exception
    return task.result
