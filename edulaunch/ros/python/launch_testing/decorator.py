"""Decorators of test classes and of `generate_test_description`."""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterable, Iterator
from typing import Any, TypeVar

from launch._lazy import has_ros_paths

from edulaunch.engine.sim.sync import sleep

T = TypeVar('T', bound=Callable[..., Any])
DEFAULT_TIMEOUT_S = 15


def post_shutdown_test() -> Callable[[type], type]:
    """Mark a `unittest.TestCase` class: its tests run after everything that was launched has ended."""

    def mark(test_class: type) -> type:
        test_class.__post_shutdown_test__ = True  # type: ignore[attr-defined]
        return test_class

    return mark


def ready_to_test_action_timeout(timeout: float = DEFAULT_TIMEOUT_S) -> Callable[[T], T]:
    """Say how many simulated seconds after the start `ReadyToTest` must have been reached.

    :param timeout: seconds; without this decorator 15.
    """

    def mark(test_description: T) -> T:
        test_description.__ready_to_test_action_timeout__ = timeout  # type: ignore[attr-defined]
        return test_description

    return mark


def keep_alive(test_description: T) -> T:
    """Let launch run on when all its processes have ended; the end of the tests shuts it down."""
    return _with_marker(test_description, 'keep_alive', True)


def retry_on_failure(*, times: int, delay: float | None = None) -> Callable[[T], T]:
    """Run a test method again when it fails, up to `times` times in all; the last failure counts.

    :param delay: simulated seconds between two times; None: none.
    :raises ValueError: for `times` below 1.
    """
    if times < 1:
        raise ValueError(f'times must be at least 1, got {times}')

    def decorate(function: T) -> T:
        @functools.wraps(function)
        def repeated(*args: Any, **kwargs: Any) -> Any:
            for _ in range(times - 1):
                try:
                    return function(*args, **kwargs)
                except AssertionError:
                    sleep(delay or 0)
            return function(*args, **kwargs)

        return _with_marker(repeated, 'retry_on_failure', {'times': times})  # type: ignore[return-value]

    return decorate


def _with_marker(function: T, name: str, value: object) -> T:
    markers = dict(getattr(function, '__markers__', {}))
    function.__markers__ = {**markers, name: value}  # type: ignore[attr-defined]
    return function


Description = Callable[..., Any]
Parametrized = Callable[[], Iterator[tuple[Description, dict[str, Any]]]]


def parametrize(argnames: str | Iterable[str], argvalues: Iterable[Any]) -> Callable[[Description], Parametrized]:
    """Launch and test once for each of `argvalues`.

    The values are arguments of `generate_test_description` and, by the same names, of the test methods.

    :param argnames: one name, several with commas between them, or a list of names.
    :param argvalues: a value for each launch; with several names a tuple of values.
    :raises ValueError: when there are more or fewer values than names.
    """
    names = [name.strip() for name in argnames.split(',') if name.strip()] if isinstance(argnames, str) else list(argnames)
    rows = [_row(names, value) for value in argvalues]

    def decorate(function: Description) -> Parametrized:
        @functools.wraps(function)
        def each() -> Iterator[tuple[Description, dict[str, Any]]]:
            for row in rows:
                yield functools.partial(function, **row), row

        each.__parametrized__ = True  # type: ignore[attr-defined]
        return each

    return decorate


def _row(names: list[str], value: Any) -> dict[str, Any]:
    plain = len(names) == 1 and not (isinstance(value, (list, tuple)) and len(value) == 1)
    values = [value] if plain else list(value)
    if len(values) != len(names):
        raise ValueError(f'parametrize: {len(names)} names {names}, but {len(values)} values {values}')
    return dict(zip(names, values, strict=True))


has_ros_paths(__name__)
