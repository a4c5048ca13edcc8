"""Launches that fixtures ask for, and the tests that run in them."""

from __future__ import annotations

import asyncio
import inspect
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any, NoReturn

import pytest
from launch.launch_description import LaunchDescription
from launch_testing.actions.ready import ReadyToTest
from launch_testing.loader import ready_actions

from edulaunch.processes.current import current_process

from ._items import IS_SECOND_PART, SHUTDOWN_ITEM, has_shutdown_kwarg, options_of
from ._running import run_beside, run_until_complete
from .fixture import finalize_launch_service

RUNNING_TEST = pytest.StashKey[Any]()
"""On the item of a second part: the generator, once its first part is over."""
Finalize = Callable[[], None]


def run_launched_test(item: pytest.Function) -> None:
    """Run the function of an item.

    :raises: whatever the test raises, and pytest's failures of our own.
    """
    __tracebackhide__ = True
    funcargs: dict[str, Any] = item.funcargs
    loop = funcargs['event_loop']
    options = options_of(item)
    assert options is not None
    finalize = partial(
        finalize_launch_service,
        funcargs['launch_service'],
        eprefix=f"When running test '{item.name}':",
        auto_shutdown=options['auto_shutdown'],
    )
    if item.stash.get(IS_SECOND_PART, False):
        _run_second_part(item, loop, finalize)
        return
    if has_shutdown_kwarg(item):
        finalize()
    arguments = {name: funcargs[name] for name in item._fixtureinfo.argnames}
    function = item.obj
    if inspect.iscoroutinefunction(function):
        run_until_complete(loop, function(**arguments), 'the test did not come to its end')
    elif inspect.isgeneratorfunction(function) or inspect.isasyncgenfunction(function):
        _run_first_part(item, loop, function(**arguments), finalize)
    else:
        run_beside(loop, partial(function, **arguments))


def _run_first_part(item: pytest.Function, loop: Any, test: Any, finalize: Finalize) -> None:
    """Run a generator test up to its `yield`, and with a launch of its own also the rest."""
    __tracebackhide__ = True
    if not _advance(loop, test):
        pytest.fail('launch tests using a generator function must yield once: it ended before', pytrace=False)
    second = item.stash.get(SHUTDOWN_ITEM, None)
    if second is not None:
        second.stash[RUNNING_TEST] = test
        return
    finalize()
    _finish(loop, test)


def _run_second_part(item: pytest.Function, loop: Any, finalize: Finalize) -> None:
    __tracebackhide__ = True
    test = item.stash.get(RUNNING_TEST, None)
    if test is None:
        pytest.skip('the part of the test before its yield did not run to it')
    del item.stash[RUNNING_TEST]
    finalize()
    _finish(loop, test)


def _finish(loop: Any, test: Any) -> None:
    """Run what comes behind the `yield`."""
    __tracebackhide__ = True
    if _advance(loop, test):
        _close(loop, test)
        _complain_of_second_yield(test)


def _complain_of_second_yield(test: Any) -> NoReturn:
    kind = 'an async gen' if inspect.isasyncgen(test) else 'a generator'
    pytest.fail(f'launch tests using {kind} function must stop iteration after yielding once', pytrace=False)


def _advance(loop: Any, test: Any) -> bool:
    """Run a generator test up to its next `yield`; False when it has ended."""
    __tracebackhide__ = True
    if not inspect.isasyncgen(test):
        return bool(run_beside(loop, lambda: next(test, _END) is not _END))

    async def advance() -> bool:
        try:
            await test.__anext__()
        except StopAsyncIteration:
            return False
        return True

    return bool(run_until_complete(loop, advance(), 'the test did not come to its end'))


def _close(loop: Any, test: Any) -> None:
    if inspect.isasyncgen(test):
        run_until_complete(loop, test.aclose(), 'the test did not come to its end')
    else:
        test.close()


_END = object()


def launch_description_of(result: object, prefix: str) -> LaunchDescription:
    """What a launch fixture has returned.

    :raises: pytest's failure for anything but a description, or a sequence that begins with one.
    """
    first = result[0] if isinstance(result, Sequence) and not isinstance(result, str) and result else result
    if isinstance(first, LaunchDescription):
        return first
    pytest.fail(
        f'{prefix} return value must be either a launch description or a sequence whose first item is a launch '
        f'description\n  help: it is {_kind(result)}; let the function return LaunchDescription([...])',
        pytrace=False,
    )


def _kind(value: object) -> str:
    return 'None' if value is None else f'of type {type(value).__name__}'


def get_ready_to_test_action(description: LaunchDescription) -> ReadyToTest:
    """The `ReadyToTest` of a description; one is added at its end when there is none.

    :raises: pytest's failure when there are several.
    """
    found = ready_actions(description)
    if not found:
        found = [ReadyToTest()]
        description.add_action(found[0])
    elif len(found) > 1:
        pytest.fail(
            'launch_pytest fixtures must return a LaunchDescription containing only one ReadyToTest action', pytrace=False
        )
    return found[0]


def launch_until_ready(service: Any, loop: Any, description: LaunchDescription, prefix: str, shutdown_when_idle: bool) -> None:
    """Run a description up to its `ReadyToTest`. A service that runs already, for another fixture of its scope, takes it in."""
    ready = loop.create_future()
    get_ready_to_test_action(description)._add_callback(_once(ready))
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


def _once(ready: Any) -> Callable[[], None]:
    def tell() -> None:
        if not ready.done():
            ready.set_result(None)

    return tell
