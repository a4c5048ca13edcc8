"""Decorators of `generate_test_description` and of test methods."""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import Any

from edulaunch.engine.sim.sync import sleep

from .decorator import T


def keep_alive(test_description: T) -> T:
    """Keep a launch running after all its processes have ended. The launch is shut down after the tests."""
    return _with_marker(test_description, 'keep_alive', True)


def retry_on_failure(*, times: int, delay: float | None = None) -> Callable[[T], T]:
    """Repeat a test method that fails with an AssertionError. If all attempts fail, the last failure counts.

    :param times: the maximum number of attempts.
    :param delay: simulated seconds between two attempts; None means no pause.
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
