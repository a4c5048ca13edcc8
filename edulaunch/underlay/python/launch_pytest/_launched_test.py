"""Running one launch test: beside the launch, after its shutdown, or first the one and then the other."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from functools import partial
from typing import Any, NoReturn

import pytest

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
