"""The pytest plugin of launch_pytest. edulaunch's own plugin registers it when a test file needs it."""

from __future__ import annotations

import functools
from collections.abc import Generator
from contextlib import suppress
from typing import Any

import pytest

from ._items import (
    LaunchTestWarning,
    complaint_about,
    function_item,
    has_shutdown_kwarg,
    is_launch_test,
    make_items,
    shutdown_tests_last,
)
from ._launched import launch_description_of, launch_until_ready, run_launched_test
from .fixture import OPTIONS, finalize_launch_service

__all__ = ['LaunchTestWarning', 'has_shutdown_kwarg', 'is_launch_test']


def pytest_configure(config: pytest.Config) -> None:
    """Make the mark known."""
    config.addinivalue_line(
        'markers',
        'launch(fixture, shutdown=False): a test of what the launch fixture describes, run beside '
        'it, or after its shutdown (edulaunch)',
    )


@pytest.hookimpl(wrapper=True, tryfirst=True)
def pytest_pycollect_makeitem(collector: Any, name: str, obj: object) -> Generator[None, Any, Any]:
    """Make the tests of a function marked `launch`. What pytest itself, or pytest-asyncio, would make of it is not used."""
    item = function_item(collector, name, obj)
    if item is None or not is_launch_test(item):
        return (yield)
    with suppress(Exception, pytest.fail.Exception):
        yield
    complaint = complaint_about(item)
    if complaint is None:
        return make_items(collector, name, obj, item)
    item.warn(LaunchTestWarning(complaint))
    item.add_marker(pytest.mark.skip(complaint))
    return [item]


@pytest.hookimpl(trylast=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Tests of a launch that has ended come after those that need it running."""
    items[:] = shutdown_tests_last(items)


@pytest.hookimpl(tryfirst=True)
def pytest_pyfunc_call(pyfuncitem: pytest.Function) -> bool | None:
    """Run a launch test in simulated time."""
    __tracebackhide__ = True
    if not is_launch_test(pyfuncitem):
        return None
    run_launched_test(pyfuncitem)
    return True


@pytest.hookimpl(wrapper=True, tryfirst=True)
def pytest_fixture_setup(fixturedef: Any, request: pytest.FixtureRequest) -> Generator[None, Any, Any]:
    """Launch what a launch fixture describes, and wait until it is ready."""
    options = getattr(fixturedef.func, OPTIONS, None)
    if options is None:
        return (yield)
    prefix = f"When running launch_pytest fixture '{options['name']}':"
    service = request.getfixturevalue('launch_service')
    loop = request.getfixturevalue('event_loop')
    result = yield
    description = launch_description_of(result, prefix)
    fixturedef.addfinalizer(
        functools.partial(finalize_launch_service, service, eprefix=prefix, auto_shutdown=options['auto_shutdown'])
    )
    launch_until_ready(service, loop, description, prefix, options['shutdown_when_idle'])
    return result
