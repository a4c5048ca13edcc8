"""The action `PushLaunchConfigurations`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..action import Action

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class PushLaunchConfigurations(Action):
    """Save all launch configurations until the matching `PopLaunchConfigurations`."""

    def execute(self, context: LaunchContext) -> None:
        """Save the launch configurations for a later `PopLaunchConfigurations`."""
        context._push_launch_configurations()
