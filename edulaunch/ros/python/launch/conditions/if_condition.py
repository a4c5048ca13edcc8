"""The condition `IfCondition`."""

from __future__ import annotations

from ._expression_condition import _ExpressionCondition


class IfCondition(_ExpressionCondition):
    """Execute the action only if the expression is `true` or `1`. The only other allowed values are `false` and `0`.

    :raises InvalidConditionExpressionError: on evaluation, when the expression is any other string.
    """

    _word = 'if'
