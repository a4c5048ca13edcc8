"""The action `SetROSLogDir`."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

from launch._bases import ReadOnly
from launch.action import Action
from launch.substitution import SomeSubstitutionsType, Substitution
from launch.utilities.texts import normalize_to_list_of_substitutions, perform_substitutions

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


class SetROSLogDir(Action):
    """Set ROS_LOG_DIR for later nodes in the same scope. A relative path is a folder in the current log folder."""

    def __init__(self, new_log_dir: SomeSubstitutionsType, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__log_dir = normalize_to_list_of_substitutions(new_log_dir)

    log_dir: ReadOnly[list[Substitution]] = ReadOnly('The folder, as substitutions.')

    def execute(self, context: LaunchContext) -> None:
        """Set the environment variable `ROS_LOG_DIR`."""
        folder = perform_substitutions(context, self.__log_dir)
        if not os.path.isabs(folder):
            folder = os.path.join(context.environment.get('ROS_LOG_DIR') or _launch_log_dir(context), folder)
        context.environment['ROS_LOG_DIR'] = folder


def _launch_log_dir(context: LaunchContext) -> str:
    from launch.substitutions.launch_log_dir import LaunchLogDir

    return LaunchLogDir().perform(context)
