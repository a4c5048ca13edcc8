"""The decorator for fixtures that return launch descriptions, and the fixtures that it adds."""

from __future__ import annotations

import asyncio
import sys
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any

import pytest

from edulaunch.engine.processes.current import current_process

from ._running import run_until_complete

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext
    from launch.launch_service import LaunchService

SCOPES = ('function', 'class', 'module', 'package', 'session')
OPTIONS = 'launch_pytest_options'
"""An attribute of a launch fixture: its name, its scope, and how its launch ends."""
SCOPE = 'launch_pytest_scope'
"""An attribute of the fixtures that belong to it."""


def finalize_launch_service(launch_service: LaunchService, eprefix: str = '', auto_shutdown: bool = True) -> None:
    """Wait until a launch has ended. Do nothing if it has already ended.

    :param eprefix: the beginning of the failure's message.
    :param auto_shutdown: whether to request the shutdown first.
    :raises AssertionError: when the launch has ended with a return code that is not 0.
    """
    if auto_shutdown:
        launch_service.shutdown(force_sync=True)
    loop, task = launch_service.event_loop, launch_service.task
    if loop is not None and task is not None and not loop.is_closed():
        code = run_until_complete(loop, task, 'the launch did not come to its end')
        assert code == 0, f"{eprefix} launch service failed when finishing, return code '{code}'"


def companions(scope: Any) -> dict[str, Any]:
    """Return the fixtures `event_loop`, `launch_service` and `launch_context`, all with the same scope."""

    @pytest.fixture(scope=scope)
    def event_loop() -> Iterator[asyncio.AbstractEventLoop]:
        """The asyncio loop in simulated time that runs the launch and coroutines."""
        from edulaunch.engine.processes.module_views.asyncio_view import ProcessEventLoop

        process = current_process()
        loop = ProcessEventLoop(process, process.lifecycle.task)
        yield loop
        loop.close()

    @pytest.fixture(scope=scope)
    def launch_service(event_loop: asyncio.AbstractEventLoop) -> Iterator[LaunchService]:
        """The service that executes the launch descriptions."""
        from launch.launch_service import LaunchService

        service = LaunchService()
        yield service
        finalize_launch_service(service, eprefix='When tearing down launch_service fixture')

    @pytest.fixture(scope=scope)
    def launch_context(launch_service: LaunchService) -> LaunchContext:
        """The context of the launch."""
        return launch_service.context

    return {'event_loop': event_loop, 'launch_service': launch_service, 'launch_context': launch_context}


def fixture(
    decorated: Callable[..., Any] | None = None,
    *args: Any,
    shutdown_when_idle: bool = True,
    auto_shutdown: bool = True,
    **kwargs: Any,
) -> Any:
    """Make a pytest fixture from a function that returns a launch description. The description is launched before the tests that
    use the fixture.

    The function returns (or yields) a LaunchDescription, or a sequence that begins with a LaunchDescription. The decorator
    adds the fixtures `event_loop`, `launch_service` and `launch_context` of the same scope to the function's module.
    Existing fixtures of these names, or of a wider scope, are not replaced.

    :param shutdown_when_idle: whether to end the launch when nothing is left to do.
    :param auto_shutdown: whether to shut the launch down after the tests. Otherwise, wait until the launch ends.
    :param kwargs: the arguments of `pytest.fixture`.
    """
    scope = kwargs.get('scope', 'function')
    module = sys._getframe(1).f_globals
    for name, made in companions(scope).items():
        before = getattr(module.get(name), SCOPE, None)
        if name not in module or (before is not None and _lifetime(scope) > _lifetime(before)):
            setattr(made, SCOPE, scope)
            module[name] = made

    def decorate(function: Callable[..., Any]) -> Any:
        options = {
            'name': kwargs.get('name') or function.__name__,
            'scope': scope,
            'auto_shutdown': auto_shutdown,
            'shutdown_when_idle': shutdown_when_idle,
        }
        setattr(function, OPTIONS, options)
        made: Any = pytest.fixture(*args, **kwargs)(function)
        setattr(made, OPTIONS, options)
        return made

    return decorate if decorated is None else decorate(decorated)


def _lifetime(scope: Any) -> int:
    return SCOPES.index(scope) if scope in SCOPES else -1
