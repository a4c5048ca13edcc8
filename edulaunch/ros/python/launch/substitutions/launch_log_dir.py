"""The substitution `LaunchLogDir`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..substitution import Substitution

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class LaunchLogDir(Substitution):
    """The folder of this launch's log files. The first use creates the folder."""

    def describe(self) -> str:
        """Return the description `LaunchLogDir()`."""
        return 'LaunchLogDir()'

    def perform(self, context: LaunchContext) -> str:
        """Return the folder."""
        from ..logging import launch_config

        log_dir: str = launch_config.log_dir
        return log_dir
