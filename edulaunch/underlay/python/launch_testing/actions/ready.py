"""The moment when the tests may begin."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from launch.action import Action
from launch.launch_context import LaunchContext


class ReadyToTest(Action):
    """Executing it begins the tests. A test description contains exactly one; it may be in a timer or event handler."""

    def __init__(self, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__callbacks: list[Callable[[], object]] = []

    def _add_callback(self, callback: Callable[[], object]) -> None:
        """Call `callback()` when this is executed; used by the test runner."""
        self.__callbacks.append(callback)

    def execute(self, context: LaunchContext) -> None:
        """Tell the runner."""
        for callback in self.__callbacks:
            callback()
