"""The action `PopEnvironment`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..action import Action

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class PopEnvironment(Action):
    """Restore the environment variables saved by the last `PushEnvironment`."""

    def execute(self, context: LaunchContext) -> None:
        """Restore the environment variables saved by the last `PushEnvironment`.

        :raises RuntimeError: when there is no earlier `PushEnvironment`.
        """
        context._pop_environment()
