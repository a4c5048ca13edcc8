"""A condition that is neither true nor false."""


class InvalidConditionExpressionError(ValueError):
    """The text of a condition is none of true, 1, false and 0."""
