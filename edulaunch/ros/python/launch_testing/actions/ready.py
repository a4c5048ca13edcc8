"""The action `ReadyToTest`."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from launch.action import Action
from launch.launch_context import LaunchContext


class ReadyToTest(Action):
    """Start the tests. A test description contains exactly one such action, which may be in a timer or event handler."""

    def __init__(self, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__callbacks: list[Callable[[], object]] = []

    def call_when_executed(self, callback: Callable[[], object]) -> None:
        """Store `callback()` to call it when this action is executed. Code that runs tests uses this method."""
        self.__callbacks.append(callback)

    def execute(self, context: LaunchContext) -> None:
        """Call the callback."""
        for callback in self.__callbacks:
            callback()
