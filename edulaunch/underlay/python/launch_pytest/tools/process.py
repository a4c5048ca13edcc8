"""Waiting until a process has started, ended or written something.

Each has two forms: a coroutine, and a `..._sync` one for tests that are plain functions. Timeouts are in simulated seconds; None
waits for as long as it takes. Actions whose output is looked at need `cached_output=True`.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from edulaunch.sim import sync

if TYPE_CHECKING:
    from launch.actions.execute_local import ExecuteLocal
    from launch.launch_context import LaunchContext

Validate = Callable[[str], 'bool | None']
Read = Callable[[], str]


async def wait_for_output(
    launch_context: LaunchContext, process_action: ExecuteLocal, validate_output: Validate, timeout: float | None = None
) -> bool:
    """Wait until all that a process wrote to its standard output is as it should be; False when it is not in time.

    :param validate_output: called with the text; it returns whether it is right, or makes assertions and returns nothing.
    """
    return await _wait(launch_context, process_action, 'io', _holds(process_action.get_stdout, validate_output), timeout)


def wait_for_output_sync(
    launch_context: LaunchContext, process_action: ExecuteLocal, validate_output: Validate, timeout: float | None = None
) -> bool:
    """As :func:`wait_for_output`, for tests that are no coroutines."""
    return _wait_sync(launch_context, process_action, 'io', _holds(process_action.get_stdout, validate_output), timeout)


async def assert_output(
    launch_context: LaunchContext, process_action: ExecuteLocal, validate_output: Validate, timeout: float | None = None
) -> None:
    """As :func:`wait_for_output`. Raises AssertionError when it is not in time: that of `validate_output`, if it makes any."""
    if not await wait_for_output(launch_context, process_action, validate_output, timeout):
        _complain('stdout', process_action.get_stdout(), validate_output)


def assert_output_sync(
    launch_context: LaunchContext, process_action: ExecuteLocal, validate_output: Validate, timeout: float | None = None
) -> None:
    """As :func:`assert_output`, for tests that are no coroutines."""
    if not wait_for_output_sync(launch_context, process_action, validate_output, timeout):
        _complain('stdout', process_action.get_stdout(), validate_output)


async def wait_for_stderr(
    launch_context: LaunchContext, process_action: ExecuteLocal, validate_output: Validate, timeout: float | None = None
) -> bool:
    """As :func:`wait_for_output`, for the standard error, where nodes log."""
    return await _wait(launch_context, process_action, 'io', _holds(process_action.get_stderr, validate_output), timeout)


def wait_for_stderr_sync(
    launch_context: LaunchContext, process_action: ExecuteLocal, validate_output: Validate, timeout: float | None = None
) -> bool:
    """As :func:`wait_for_stderr`, for tests that are no coroutines."""
    return _wait_sync(launch_context, process_action, 'io', _holds(process_action.get_stderr, validate_output), timeout)


async def assert_stderr(
    launch_context: LaunchContext, process_action: ExecuteLocal, validate_output: Validate, timeout: float | None = None
) -> None:
    """As :func:`assert_output`, for the standard error."""
    if not await wait_for_stderr(launch_context, process_action, validate_output, timeout):
        _complain('stderr', process_action.get_stderr(), validate_output)


def assert_stderr_sync(
    launch_context: LaunchContext, process_action: ExecuteLocal, validate_output: Validate, timeout: float | None = None
) -> None:
    """As :func:`assert_stderr`, for tests that are no coroutines."""
    if not wait_for_stderr_sync(launch_context, process_action, validate_output, timeout):
        _complain('stderr', process_action.get_stderr(), validate_output)


async def wait_for_start(launch_context: LaunchContext, process_action: ExecuteLocal, timeout: float | None = None) -> bool:
    """Wait until a process has started (it may have ended since); False when it has not in time."""
    return await _wait(launch_context, process_action, 'start', lambda: process_action.process_details is not None, timeout)


def wait_for_start_sync(launch_context: LaunchContext, process_action: ExecuteLocal, timeout: float | None = None) -> bool:
    """As :func:`wait_for_start`, for tests that are no coroutines."""
    return _wait_sync(launch_context, process_action, 'start', lambda: process_action.process_details is not None, timeout)


async def wait_for_exit(launch_context: LaunchContext, process_action: ExecuteLocal, timeout: float | None = None) -> bool:
    """Wait until a process has ended; False when it has not in time."""
    return await _wait(launch_context, process_action, 'exit', lambda: process_action.return_code is not None, timeout)


def wait_for_exit_sync(launch_context: LaunchContext, process_action: ExecuteLocal, timeout: float | None = None) -> bool:
    """As :func:`wait_for_exit`, for tests that are no coroutines."""
    return _wait_sync(launch_context, process_action, 'exit', lambda: process_action.return_code is not None, timeout)


wait_for_stdout, wait_for_stdout_sync = wait_for_output, wait_for_output_sync
assert_stdout, assert_stdout_sync = assert_output, assert_output_sync


async def _wait(
    context: LaunchContext, action: ExecuteLocal, kind: str, condition: Callable[[], bool], timeout: float | None
) -> bool:
    """Look at the condition now and after each event of that kind."""
    news = asyncio.Event()
    handler = _handler(kind, action, news.set)
    context.register_event_handler(handler)

    async def until_it_holds() -> None:
        while not condition():
            await news.wait()
            news.clear()

    try:
        await asyncio.wait_for(until_it_holds(), timeout)
    except asyncio.TimeoutError:
        return condition()
    finally:
        context.unregister_event_handler(handler)
    return True


def _wait_sync(
    context: LaunchContext, action: ExecuteLocal, kind: str, condition: Callable[[], bool], timeout: float | None
) -> bool:
    news = sync.Condition()

    def tell() -> None:
        with news:
            news.notify_all()

    handler = _handler(kind, action, tell)
    context.register_event_handler(handler)
    try:
        with news:
            return bool(news.wait_for(condition, timeout))
    finally:
        context.unregister_event_handler(handler)


def _handler(kind: str, action: ExecuteLocal, tell: Callable[[], object]) -> Any:
    """What calls `tell` after each event of that kind."""
    from launch.event_handlers import OnProcessExit, OnProcessIO, OnProcessStart

    def on_event(event: object, context: object = None) -> None:
        tell()

    if kind == 'start':
        return OnProcessStart(target_action=action, on_start=on_event)
    if kind == 'exit':
        return OnProcessExit(target_action=action, on_exit=on_event)
    return OnProcessIO(target_action=action, on_stdout=on_event, on_stderr=on_event)


def _holds(read: Read, validate: Validate) -> Callable[[], bool]:
    def condition() -> bool:
        try:
            answer = validate(read())
        except AssertionError:
            return False
        return answer is None or bool(answer)

    return condition


def _complain(stream: str, text: str, validate: Validate) -> None:
    """Let the test's own assertions tell what is wrong; else say what there was."""
    validate(text)
    raise AssertionError(f'the {stream} never was as expected; it is {text!r}')
