"""Whether two texts differ."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .._parsed_by import parsed_as_substitution
from .equals_substitution import EqualsSubstitution

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class NotEqualsSubstitution(EqualsSubstitution):
    """The opposite of `EqualsSubstitution`."""

    parse = parsed_as_substitution('not-equals')

    def _evaluate(self, context: LaunchContext) -> bool:
        return not super()._evaluate(context)
