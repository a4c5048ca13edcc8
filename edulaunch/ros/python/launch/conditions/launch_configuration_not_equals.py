"""The condition `LaunchConfigurationNotEquals`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .launch_configuration_equals import LaunchConfigurationEquals

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class LaunchConfigurationNotEquals(LaunchConfigurationEquals):
    """A condition that is true if the launch configuration does not equal the given string. If None is given, it is true if the
    configuration is set.
    """

    _sign = 'is not'

    def _predicate_func(self, context: LaunchContext) -> bool:
        return not super()._predicate_func(context)
