"""Decorators of test classes and of `generate_test_description`."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

T = TypeVar('T', bound=Callable[..., Any])


DEFAULT_TIMEOUT_S = 15


def post_shutdown_test() -> Callable[[type], type]:
    """Mark a `unittest.TestCase` class whose tests run after all launched processes have ended."""

    def mark(test_class: type) -> type:
        test_class.__post_shutdown_test__ = True  # type: ignore[attr-defined]
        return test_class

    return mark


def ready_to_test_action_timeout(timeout: float = DEFAULT_TIMEOUT_S) -> Callable[[T], T]:
    """Set the maximum time until `ReadyToTest`, counted from the start of the launch.

    :param timeout: the maximum in simulated seconds. Without this decorator, the maximum is 15 s.
    """

    def mark(test_description: T) -> T:
        test_description.__ready_to_test_action_timeout__ = timeout  # type: ignore[attr-defined]
        return test_description

    return mark
