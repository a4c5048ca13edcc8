"""The action `ResetEnvironment`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..action import Action

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class ResetEnvironment(Action):
    """Restore the environment variables to their values at the start of the launch."""

    def execute(self, context: LaunchContext) -> None:
        """Restore the variables to their values at the start of the launch."""
        context._reset_environment()
