"""The folder of the current launch file."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..substitution import Substitution
from .substitution_failure import SubstitutionFailure

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class ThisLaunchFileDir(Substitution):
    """The folder of the current launch file, absolute.

    "Current" is the file included last, also after its include has returned, as in ROS 2.

    :raises SubstitutionFailure: on evaluation, outside of launch files.
    """

    def describe(self) -> str:
        """`ThisLaunchFileDir()`."""
        return 'ThisLaunchFileDir()'

    def perform(self, context: LaunchContext) -> str:
        """The directory."""
        known = context.get_locals_as_dict()
        if 'current_launch_file_directory' not in known:
            raise SubstitutionFailure('ThisLaunchFileDir used outside of a launch file (in a script)')
        path: str = known['current_launch_file_directory']
        return path
