"""Functions that wait until a process has started, has ended, or has written something.

Each function has two forms: a coroutine, and one ending in `_sync` for tests that are plain functions. Timeouts are in simulated
seconds; None waits without a limit. Actions whose output is checked need `cached_output=True`.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import Any

from launch.actions.execute_local import ExecuteLocal
from launch.event_handlers import OnProcessExit, OnProcessIO, OnProcessStart
from launch.launch_context import LaunchContext

from edulaunch.engine.sim import sync

Validate = Callable[[str], 'bool | None']
Holds = Callable[[], bool]


async def _wait(context: LaunchContext, handler: Callable[[Any], Any], holds: Holds, timeout: float | None) -> bool:
    """Check the condition now and after each event, until it is true or the timeout is over."""
    news = asyncio.Event()
    on_event = handler(lambda event, context=None: news.set())
    context.register_event_handler(on_event)

    async def until_it_holds() -> None:
        while not holds():
            await news.wait()
            news.clear()

    try:
        await asyncio.wait_for(until_it_holds(), timeout)
    except asyncio.TimeoutError:
        return holds()
    finally:
        context.unregister_event_handler(on_event)
    return True


def _wait_sync(context: LaunchContext, handler: Callable[[Any], Any], holds: Holds, timeout: float | None) -> bool:
    news = sync.Condition()

    def tell(event: object, context: object = None) -> None:
        with news:
            news.notify_all()

    on_event = handler(tell)
    context.register_event_handler(on_event)
    try:
        with news:
            return bool(news.wait_for(holds, timeout))
    finally:
        context.unregister_event_handler(on_event)


def _written(action: ExecuteLocal, stream: str) -> str:
    return action.get_stdout() if stream == 'stdout' else action.get_stderr()


def _look(action: ExecuteLocal, validate: Validate, stream: str) -> tuple[Callable[[Any], Any], Holds]:
    """Return the event handler for new output, and whether the output so far matches."""

    def holds() -> bool:
        try:
            answer = validate(_written(action, stream))
        except AssertionError:
            return False
        return answer is None or bool(answer)

    return lambda tell: OnProcessIO(target_action=action, on_stdout=tell, on_stderr=tell), holds


def _complain(action: ExecuteLocal, validate: Validate, stream: str) -> None:
    """Raise an error: that of the test's own assertions, or else one that shows the output."""
    written = _written(action, stream)
    validate(written)
    raise AssertionError(f'the {stream} never was as expected; it is {written!r}')


def _for_output(stream: str) -> tuple[Any, Any, Any, Any]:
    """Return the four functions that check the output of a process on 'stdout' or 'stderr'."""

    async def wait(
        launch_context: LaunchContext, process_action: ExecuteLocal, validate_output: Validate, timeout: float | None = None
    ) -> bool:
        """Wait until the output of a process is as expected. Return False if this does not happen before the timeout.

        :param validate_output: a function that is called with the output. It returns whether the output is as expected, or makes
            assertions and returns None.
        """
        return await _wait(launch_context, *_look(process_action, validate_output, stream), timeout)

    def wait_sync(
        launch_context: LaunchContext, process_action: ExecuteLocal, validate_output: Validate, timeout: float | None = None
    ) -> bool:
        """Wait in a plain function; see the coroutine of the same name without `_sync`."""
        return _wait_sync(launch_context, *_look(process_action, validate_output, stream), timeout)

    async def check(
        launch_context: LaunchContext, process_action: ExecuteLocal, validate_output: Validate, timeout: float | None = None
    ) -> None:
        """Wait as `wait_for_...` does. After the timeout, raise AssertionError, or the error that `validate_output` raises."""
        if not await wait(launch_context, process_action, validate_output, timeout):
            _complain(process_action, validate_output, stream)

    def check_sync(
        launch_context: LaunchContext, process_action: ExecuteLocal, validate_output: Validate, timeout: float | None = None
    ) -> None:
        """Check in a plain function; see the coroutine of the same name without `_sync`."""
        if not wait_sync(launch_context, process_action, validate_output, timeout):
            _complain(process_action, validate_output, stream)

    return wait, wait_sync, check, check_sync


def _for_event(handler: Callable[..., Any], argument: str, has_come: Callable[[ExecuteLocal], bool]) -> tuple[Any, Any]:
    """Return the two functions that wait for the start or the end of a process."""

    def look(action: ExecuteLocal) -> tuple[Callable[[Any], Any], Holds]:
        return lambda tell: handler(target_action=action, **{argument: tell}), lambda: has_come(action)

    async def wait(launch_context: LaunchContext, process_action: ExecuteLocal, timeout: float | None = None) -> bool:
        """Wait until the process has started or ended. Return False if this does not happen before the timeout.

        A process that has started may already have ended.
        """
        return await _wait(launch_context, *look(process_action), timeout)

    def wait_sync(launch_context: LaunchContext, process_action: ExecuteLocal, timeout: float | None = None) -> bool:
        """Wait in a plain function; see the coroutine of the same name without `_sync`."""
        return _wait_sync(launch_context, *look(process_action), timeout)

    return wait, wait_sync


wait_for_output, wait_for_output_sync, assert_output, assert_output_sync = _for_output('stdout')
wait_for_stdout, wait_for_stdout_sync, assert_stdout, assert_stdout_sync = _for_output('stdout')
wait_for_stderr, wait_for_stderr_sync, assert_stderr, assert_stderr_sync = _for_output('stderr')
wait_for_start, wait_for_start_sync = _for_event(OnProcessStart, 'on_start', lambda action: action.process_details is not None)
wait_for_exit, wait_for_exit_sync = _for_event(OnProcessExit, 'on_exit', lambda action: action.return_code is not None)
for _name in [name for name in globals() if name.startswith(('wait_for_', 'assert_'))]:
    globals()[_name].__name__ = globals()[_name].__qualname__ = _name  # for help and tracebacks
