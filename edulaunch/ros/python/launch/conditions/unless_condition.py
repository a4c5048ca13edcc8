"""The condition `UnlessCondition`."""

from __future__ import annotations

from ._expression_condition import _ExpressionCondition


class UnlessCondition(_ExpressionCondition):
    """Execute the action only if the expression is `false` or `0`. The only other allowed values are `true` and `1`.

    :raises InvalidConditionExpressionError: on evaluation, when the expression is any other string.
    """

    _word = 'unless'
