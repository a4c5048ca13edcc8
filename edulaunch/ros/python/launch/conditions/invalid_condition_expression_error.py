"""The error for a condition that is not a boolean."""

from __future__ import annotations


class InvalidConditionExpressionError(ValueError):
    """The condition is not true, 1, false or 0."""
