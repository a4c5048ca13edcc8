"""The substitution `NotEqualsSubstitution`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .equals_substitution import EqualsSubstitution

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class NotEqualsSubstitution(EqualsSubstitution):
    """The opposite of `EqualsSubstitution`."""

    def _evaluate(self, context: LaunchContext) -> bool:
        return not super()._evaluate(context)
