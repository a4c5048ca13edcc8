"""The condition `UnlessCondition`."""

from __future__ import annotations

from ._expression_condition import _ExpressionCondition


class UnlessCondition(_ExpressionCondition):
    """Execute the action only if the expression is `false` or `0` (any case).

    :raises InvalidConditionExpressionError: on evaluation, for a string that is neither true nor false.
    """

    _word = 'unless'
