"""The pytest plugin of launch_pytest. It decides which functions are launch tests, and how and when they run.

edulaunch's own plugin registers it when a test file needs it.
"""

from __future__ import annotations

import inspect
from collections.abc import Generator
from contextlib import suppress
from functools import partial
from typing import Any

import pytest

from ._running import TEST_HANGS, advance, finish, launch_description_of, launch_until_ready, run_beside, run_until_complete
from .fixture import OPTIONS, finalize_launch_service

SHUTDOWN_ITEM = pytest.StashKey[pytest.Function]()
"""An attribute of a generator test that shares its launch with others: the item that runs its second part."""
RUNNING_TEST = pytest.StashKey[Any]()
"""An attribute of that item: the generator once its first part is over, and None before."""
NODES: dict[Any, Any] = {'class': pytest.Class, 'module': pytest.Module, 'package': pytest.Package}


class LaunchTestWarning(pytest.PytestWarning):
    """A launch test was skipped because its mark is invalid."""


def pytest_configure(config: pytest.Config) -> None:
    """Register the mark."""
    config.addinivalue_line(
        'markers',
        'launch(fixture, shutdown=False): a test of what the launch fixture describes, run beside '
        'it, or after its shutdown (edulaunch)',
    )


@pytest.hookimpl(wrapper=True, tryfirst=True)
def pytest_pycollect_makeitem(collector: Any, name: str, obj: object) -> Generator[None, Any, Any]:
    """Create the tests of a function marked `launch`, in place of the items of pytest or pytest-asyncio."""
    if not (inspect.isfunction(obj) or inspect.ismethod(obj)) or not collector.istestfunction(obj, name):
        return (yield)
    item: pytest.Function = pytest.Function.from_parent(collector, name=name, callobj=obj)
    mark = item.get_closest_marker('launch')
    if mark is None:
        return (yield)
    with suppress(Exception, pytest.fail.Exception):
        yield
    complaint = _complaint_about(mark, item.obj)
    if complaint is None:
        return _make_items(collector, name, obj, _options(item))
    item.warn(LaunchTestWarning(complaint))
    item.add_marker(pytest.mark.skip(complaint))
    return [item]


def _options(item: pytest.Item) -> dict[str, Any]:
    """Return the options that `launch_pytest.fixture` stored for the fixture in an item's mark: name, scope, auto_shutdown and
    shutdown_when_idle.

    The result is empty for an item without such a fixture.
    """
    mark = item.get_closest_marker('launch')
    options: dict[str, Any] = {} if mark is None else getattr(mark.kwargs.get('fixture'), OPTIONS, {})
    return options


def _is_for_shutdown(item: pytest.Item) -> bool:
    """Return whether a test must run after the launch has ended."""
    mark = item.get_closest_marker('launch')
    return mark is not None and bool(mark.kwargs.get('shutdown', False))


def _has_two_parts(function: object) -> bool:
    """Return whether a test function contains `yield`. The part after the `yield` runs after the shutdown."""
    return inspect.isgeneratorfunction(function) or inspect.isasyncgenfunction(function)


def _complaint_about(mark: pytest.Mark, function: object) -> str | None:
    """Return a message about an invalid `launch` mark, or None if the mark is valid."""
    fixture = mark.kwargs.get('fixture')
    if fixture is None:
        return '"fixture" keyword argument is required in a pytest.mark.launch() decorator'
    if not hasattr(fixture, OPTIONS):
        name = getattr(fixture, '__name__', fixture)
        return f'"fixture" of pytest.mark.launch() must be a launch fixture: decorate {name!r} with @launch_pytest.fixture'
    if mark.kwargs.get('shutdown', False) and _has_two_parts(function):
        return 'generator or async generator based launch test items cannot be marked with shutdown=True'
    return None


def _make_items(collector: Any, name: str, function: Any, options: dict[str, Any]) -> list[pytest.Function]:
    """Return the items of a launch test: one for each set of parameters.

    A generator test that shares its launch with other tests has a second item, which runs after all of these tests.
    """
    pytest.mark.usefixtures(options['name'], 'launch_service', 'event_loop')(getattr(function, '__func__', function))
    items = list(collector._genfunctions(name, function))
    if not _has_two_parts(function) or options['scope'] == 'function':
        return items
    return [*items, *[_second_part(first) for first in items]]


def _second_part(first: pytest.Function) -> pytest.Function:
    """Return the item that runs the part of a test after its `yield`."""
    options: dict[str, Any] = {'callspec': first.callspec} if hasattr(first, 'callspec') else {}
    name = f'{first.originalname}[shutdown_test]'
    second: pytest.Function = pytest.Function.from_parent(
        first.parent,
        name=name + first.name.removeprefix(first.originalname),
        originalname=name,
        callobj=first.obj,
        fixtureinfo=first._fixtureinfo,
        **options,
    )
    second.stash[RUNNING_TEST] = None
    first.stash[SHUTDOWN_ITEM] = second
    return second


@pytest.hookimpl(trylast=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Sort the tests that share a launch. Tests that run after the shutdown come last."""
    places: dict[Any, list[int]] = {}
    for place, item in enumerate(items):
        options = _options(item)
        if options and options['scope'] != 'function':
            places.setdefault(_shared_launch(item, options), []).append(place)
    for group in places.values():
        members = sorted((items[place] for place in group), key=lambda item: _is_for_shutdown(item) or RUNNING_TEST in item.stash)
        for place, item in zip(group, members, strict=True):
            items[place] = item


def _shared_launch(item: pytest.Item, options: dict[str, Any]) -> tuple[Any, ...]:
    """Return the key of items that share a launch: the fixture, its parameters, and the node that is its scope."""
    node = item.getparent(NODES.get(options['scope'], pytest.Session)) or item.getparent(pytest.Module)
    parameter = getattr(item, 'callspec', None)
    value = parameter.indices.get(options['name']) if parameter is not None else None
    return options['name'], '' if node is None else node.nodeid, value


@pytest.hookimpl(wrapper=True, tryfirst=True)
def pytest_pyfunc_call(pyfuncitem: pytest.Function) -> Generator[None, Any, Any]:
    """Run the test in simulated time, with the fixtures that the test requests."""
    function = pyfuncitem.obj
    if _options(pyfuncitem):
        pyfuncitem.obj = partial(_run, pyfuncitem, function)
    try:
        return (yield)
    finally:
        pyfuncitem.obj = function


def _run(item: pytest.Function, function: Any, **arguments: Any) -> None:
    """Run the function of an item, during its launch or after it.

    :raises: any exception of the test, or pytest's failure for an invalid test.
    """
    __tracebackhide__ = True
    loop: Any = item.funcargs['event_loop']
    service: Any = item.funcargs['launch_service']
    prefix = f"When running test '{item.name}':"
    finalize = partial(finalize_launch_service, service, prefix, _options(item)['auto_shutdown'])
    if RUNNING_TEST in item.stash:
        test = item.stash[RUNNING_TEST]
        if test is None:
            pytest.skip('the part of the test before its yield did not run to it')
        finalize()
        finish(loop, test)
        return
    if _is_for_shutdown(item):
        finalize()
    if inspect.iscoroutinefunction(function):
        run_until_complete(loop, function(**arguments), TEST_HANGS)
    elif not _has_two_parts(function):
        run_beside(loop, partial(function, **arguments))
    else:
        test = function(**arguments)
        if not advance(loop, test):
            pytest.fail('launch tests using a generator function must yield once: it ended before', pytrace=False)
        if SHUTDOWN_ITEM in item.stash:
            item.stash[SHUTDOWN_ITEM].stash[RUNNING_TEST] = test
        else:
            finalize()
            finish(loop, test)


@pytest.hookimpl(wrapper=True, tryfirst=True)
def pytest_fixture_setup(fixturedef: Any, request: pytest.FixtureRequest) -> Generator[None, Any, Any]:
    """Launch the description of a launch fixture, and wait until it is ready to test."""
    options = getattr(fixturedef.func, OPTIONS, None)
    if options is None:
        return (yield)
    prefix = f"When running launch_pytest fixture '{options['name']}':"
    service = request.getfixturevalue('launch_service')
    loop = request.getfixturevalue('event_loop')
    result = yield
    description = launch_description_of(result, prefix)
    fixturedef.addfinalizer(partial(finalize_launch_service, service, prefix, options['auto_shutdown']))
    launch_until_ready(service, loop, description, prefix, options['shutdown_when_idle'])
    return result
