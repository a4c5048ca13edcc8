"""The action `PushEnvironment`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..action import Action

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class PushEnvironment(Action):
    """Save all environment variables until the matching `PopEnvironment`."""

    def execute(self, context: LaunchContext) -> None:
        """Save the environment variables for a later `PopEnvironment`."""
        context._push_environment()
