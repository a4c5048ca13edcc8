"""Including launch files of packages that are not there."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from launch.actions.configurations import SetLaunchConfiguration

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext

    from edulaunch.plan.assumptions import Assumptions


def include_if_there(assumptions: Assumptions, action: Any, context: LaunchContext) -> Any:
    """Execute an IncludeLaunchDescription; of a file in a placeholder package only the arguments are set.

    :raises Exception: whatever loading another file raises.
    """
    try:
        return type(action).execute(action, context)
    except Exception:
        if not assumptions.lacks_file(action.launch_description_source.described_location):
            raise
        return [SetLaunchConfiguration(name, value) for name, value in action.launch_arguments]
