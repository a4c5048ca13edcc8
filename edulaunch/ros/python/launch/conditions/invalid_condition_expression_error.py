"""The error for a condition that is no boolean."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    pass


class InvalidConditionExpressionError(ValueError):
    """The text of a condition is none of true, 1, false and 0."""
