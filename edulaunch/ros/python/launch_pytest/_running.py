"""Runs launches up to their `ReadyToTest`, and the parts of tests, in simulated time. Reports a wait that never ends."""

from __future__ import annotations

import asyncio
import inspect
from collections.abc import Awaitable, Callable, Sequence
from typing import Any

import pytest
from launch.launch_description import LaunchDescription
from launch_testing.actions.ready import ReadyToTest
from launch_testing.loader import ready_actions

from edulaunch.engine.processes.current import current_process
from edulaunch.engine.sim.task import Task
from edulaunch.errors import SimulationError

LONGEST_WAIT_S = 600.0
TEST_HANGS = 'the test did not come to its end'


def run_until_complete(loop: asyncio.AbstractEventLoop, awaitable: Awaitable[Any], problem: str) -> Any:
    """Run the loop until an awaitable is done, and return the result of the awaitable.

    :param problem: the message of the failure if the awaitable is not done after ten minutes of simulated time.
    :raises: the exception of the awaitable, or pytest's failure if the awaitable is not done in time.
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


async def _settled(future: asyncio.Future[Any]) -> None:
    """Wait for a future without raising its exception, because an exception that is not an `Exception` would end asyncio's
    loop.
    """
    await asyncio.wait([future])


def _resolve(future: asyncio.Future[None]) -> None:
    if not future.done():
        future.set_result(None)


def run_beside(loop: asyncio.AbstractEventLoop, body: Callable[[], Any]) -> Any:
    """Run blocking code concurrently with the loop, as upstream does in a thread. Return the result of the code.

    :raises: any exception that the code raises.
    """
    __tracebackhide__ = True
    process = current_process()
    done = loop.create_future()
    task = Task(process.sim, body, name='test', owner=process)
    task.add_done_callback(lambda _: loop.call_soon_threadsafe(_resolve, done))
    task.start()
    try:
        run_until_complete(loop, done, TEST_HANGS)
    finally:
        if not task.finished:
            task.kill()
            process.sim.run(process.sim.now_ns)
    if task.exception is not None:
        raise task.exception
    return task.result


def advance(loop: asyncio.AbstractEventLoop, test: Any) -> bool:
    """Run a test that is a generator up to its next `yield`. Return False if the test has ended."""
    __tracebackhide__ = True
    if not inspect.isasyncgen(test):
        end = object()
        return run_beside(loop, lambda: next(test, end)) is not end

    async def step() -> bool:
        try:
            await test.__anext__()
        except StopAsyncIteration:
            return False
        return True

    return bool(run_until_complete(loop, step(), TEST_HANGS))


def finish(loop: asyncio.AbstractEventLoop, test: Any) -> None:
    """Run the part of a test after its `yield`. A second `yield` is a failure."""
    __tracebackhide__ = True
    if not advance(loop, test):
        return
    kind = 'a generator'
    if inspect.isasyncgen(test):
        kind = 'an async gen'
        run_until_complete(loop, test.aclose(), TEST_HANGS)
    pytest.fail(f'launch tests using {kind} function must stop iteration after yielding once', pytrace=False)


def launch_description_of(result: object, prefix: str) -> LaunchDescription:
    """Return the launch description that a launch fixture has returned.

    :raises: pytest's failure for anything but a description, or a sequence that begins with a description.
    """
    first = result[0] if isinstance(result, Sequence) and not isinstance(result, str) and result else result
    if isinstance(first, LaunchDescription):
        return first
    kind = 'None' if result is None else f'of type {type(result).__name__}'
    pytest.fail(
        f'{prefix} return value must be either a launch description or a sequence whose first item is a launch '
        f'description\n  help: it is {kind}; let the function return LaunchDescription([...])',
        pytrace=False,
    )


def launch_until_ready(service: Any, loop: Any, description: LaunchDescription, prefix: str, shutdown_when_idle: bool) -> None:
    """Run a description up to its `ReadyToTest`. If the description has no such action, add one at its end.

    If a service already runs for another fixture of the same scope, this service includes the description.

    :raises: pytest's failure when there is more than one `ReadyToTest`, or when the launch ends before it.
    """
    found = ready_actions(description)
    if len(found) > 1:
        pytest.fail(
            'launch_pytest fixtures must return a LaunchDescription containing only one ReadyToTest action', pytrace=False
        )
    if not found:
        found = [ReadyToTest()]
        description.add_action(found[0])
    ready = loop.create_future()
    found[0].call_when_executed(lambda: _resolve(ready))
    errors_before = len(_launch_errors())
    service.include_launch_description(description)
    task = service.task or loop.create_task(service.run_async(shutdown_when_idle=shutdown_when_idle))
    run_until_complete(
        loop, asyncio.wait([ready, task], return_when=asyncio.FIRST_COMPLETED), f'{prefix} ReadyToTest was not reached'
    )
    if not ready.done():
        errors = _launch_errors()[errors_before:]
        why = f'{type(errors[0]).__name__}: {errors[0]}' if errors else 'nothing was left to do'
        pytest.fail(f'{prefix} the launch ended before ReadyToTest was reached: {why}', pytrace=False)


def _launch_errors() -> list[BaseException]:
    errors: list[BaseException] = current_process().state.get('launch.exceptions', [])
    return errors
