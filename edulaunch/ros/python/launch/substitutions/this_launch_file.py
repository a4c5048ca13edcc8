"""The substitution `ThisLaunchFile`."""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

from ..substitution import Substitution
from .substitution_failure import SubstitutionFailure

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class ThisLaunchFile(Substitution):
    """The absolute path of the current launch file.

    As in ROS 2, the current file is the file that was included last, even after launch has finished visiting it.

    :raises SubstitutionFailure: on evaluation, outside of launch files.
    """

    _local: ClassVar[str] = 'current_launch_file_path'

    def describe(self) -> str:
        """Return the description `ThisLaunchFile()`."""
        return f'{type(self).__name__}()'

    def perform(self, context: LaunchContext) -> str:
        """Return the path."""
        known = context.get_locals_as_dict()
        if self._local not in known:
            raise SubstitutionFailure(f'{type(self).__name__} used outside of a launch file (in a script)')
        path: str = known[self._local]
        return path
