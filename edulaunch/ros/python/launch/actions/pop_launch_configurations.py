"""The action `PopLaunchConfigurations`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..action import Action

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class PopLaunchConfigurations(Action):
    """Restore the launch configurations saved by the last `PushLaunchConfigurations`."""

    def execute(self, context: LaunchContext) -> None:
        """Restore the launch configurations saved by the last `PushLaunchConfigurations`.

        :raises RuntimeError: when there is no earlier `PushLaunchConfigurations`.
        """
        context._pop_launch_configurations()
