"""Launching what a launch fixture has returned."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Sequence
from typing import Any

import pytest
from launch.launch_description import LaunchDescription
from launch_testing.actions.ready import ReadyToTest
from launch_testing.loader import ready_actions

from ._running import run_until_complete


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
    from edulaunch.processes.current import current_process

    errors: list[BaseException] = current_process().state.get('launch.exceptions', [])
    return errors


def _once(ready: Any) -> Callable[[], None]:
    def tell() -> None:
        if not ready.done():
            ready.set_result(None)

    return tell
