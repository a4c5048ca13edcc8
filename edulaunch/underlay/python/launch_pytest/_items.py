"""Which functions are launch tests, what items they become, and in which order these run."""

from __future__ import annotations

import inspect
from collections.abc import Iterable
from typing import Any

import pytest

from .fixture import OPTIONS

SHUTDOWN_ITEM = pytest.StashKey[pytest.Function]()
"""On a generator test that shares its launch with others: the item that runs its second part."""
IS_SECOND_PART = pytest.StashKey[bool]()
"""On that item."""
COMPANIONS = ('launch_service', 'event_loop')


class LaunchTestWarning(pytest.PytestWarning):
    """A launch test was skipped because its mark cannot be understood."""


def function_item(collector: Any, name: str, obj: object) -> pytest.Function | None:
    """An item of a test function, to look at; None for anything else."""
    if not (inspect.isfunction(obj) or inspect.ismethod(obj)) or not collector.istestfunction(obj, name):
        return None
    item: pytest.Function = pytest.Function.from_parent(collector, name=name, callobj=obj)
    return item


def is_launch_test(item: pytest.Item) -> bool:
    """Whether an item is marked `launch`."""
    return item.get_closest_marker('launch') is not None


def get_launch_test_fixture(item: pytest.Item) -> Any:
    """The launch fixture that an item's mark names, or None."""
    mark = item.get_closest_marker('launch')
    return None if mark is None else mark.kwargs.get('fixture')


def get_launch_test_fixturename(item: pytest.Item) -> str | None:
    """The name of that fixture."""
    options = options_of(item)
    return None if options is None else str(options['name'])


def options_of(item: pytest.Item) -> dict[str, Any] | None:
    """What `launch_pytest.fixture` noted of that fixture: name, scope, auto_shutdown, shutdown_when_idle."""
    options: dict[str, Any] | None = getattr(get_launch_test_fixture(item), OPTIONS, None)
    return options


def has_shutdown_kwarg(item: pytest.Item) -> bool:
    """Whether a test is to run after the launch has ended."""
    mark = item.get_closest_marker('launch')
    return mark is not None and bool(mark.kwargs.get('shutdown', False))


def is_after_shutdown(item: pytest.Item) -> bool:
    """Whether an item is such a test, or the second part of a generator test."""
    return has_shutdown_kwarg(item) or item.stash.get(IS_SECOND_PART, False)


def complaint_about(item: pytest.Function) -> str | None:
    """What is wrong with a mark `launch`; None: nothing."""
    fixture = get_launch_test_fixture(item)
    if fixture is None:
        return '"fixture" keyword argument is required in a pytest.mark.launch() decorator'
    if options_of(item) is None:
        name = getattr(fixture, '__name__', fixture)
        return f'"fixture" of pytest.mark.launch() must be a launch fixture: decorate {name!r} with @launch_pytest.fixture'
    if has_shutdown_kwarg(item) and has_two_parts(item.obj):
        return 'generator or async generator based launch test items cannot be marked with shutdown=True'
    return None


def has_two_parts(function: object) -> bool:
    """Whether a test function yields: what comes behind that runs after the shutdown."""
    return inspect.isgeneratorfunction(function) or inspect.isasyncgenfunction(function)


def make_items(collector: Any, name: str, function: Any, item: pytest.Function) -> list[pytest.Function]:
    """The items of a launch test: one for each set of parameters.

    A generator test that shares its launch with other tests has a second item, which runs when all of them are over.
    """
    options = options_of(item)
    assert options is not None
    pytest.mark.usefixtures(options['name'], *COMPANIONS)(getattr(function, '__func__', function))
    items = list(collector._genfunctions(name, function))
    if not has_two_parts(function) or options['scope'] == 'function':
        return items
    seconds = [_second_part(first) for first in items]
    return [*items, *seconds]


def _second_part(first: pytest.Function) -> pytest.Function:
    """The item that runs what comes behind the `yield` of a test."""
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
    second.stash[IS_SECOND_PART] = True
    first.stash[SHUTDOWN_ITEM] = second
    return second


def shutdown_tests_last(items: Iterable[pytest.Item]) -> list[pytest.Item]:
    """Among the tests that share one launch, those that come after its shutdown go to the places of the last ones."""
    ordered = list(items)
    places: dict[Any, list[int]] = {}
    for place, item in enumerate(ordered):
        options = options_of(item)
        if options is not None and options['scope'] != 'function':
            places.setdefault(_shared_launch(item, options), []).append(place)
    for group in places.values():
        members = sorted((ordered[place] for place in group), key=is_after_shutdown)
        for place, item in zip(group, members, strict=True):
            ordered[place] = item
    return ordered


def _shared_launch(item: pytest.Item, options: dict[str, Any]) -> tuple[Any, ...]:
    """What is equal for items that share a launch: the fixture, its parameters, and the node that is its scope."""
    scopes: dict[str, Any] = {'class': pytest.Class, 'module': pytest.Module, 'package': pytest.Package}
    kind = scopes.get(options['scope'], pytest.Session)
    node = item.getparent(kind) or item.getparent(pytest.Module)
    parameter = getattr(item, 'callspec', None)
    value = parameter.indices.get(options['name']) if parameter is not None else None
    return options['name'], '' if node is None else node.nodeid, value
