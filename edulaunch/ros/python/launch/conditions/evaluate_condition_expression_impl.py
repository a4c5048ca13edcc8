"""Convert a string to a boolean for conditions."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from ..substitution import Substitution
from ..utilities.texts import perform_substitutions
from .invalid_condition_expression_error import InvalidConditionExpressionError

if TYPE_CHECKING:
    from ..launch_context import LaunchContext

VALID_TRUE_EXPRESSIONS = ['true', '1']


VALID_FALSE_EXPRESSIONS = ['false', '0']


def evaluate_condition_expression(context: LaunchContext, expression: Iterable[Substitution]) -> bool:
    """Join the substitutions and return the boolean value of the result.

    The result must be `true`, `1`, `false` or `0`. Upper and lower case are equal, and spaces around the word are ignored.

    :raises InvalidConditionExpressionError: for any other string, including 'yes' and 'on'.
    """
    expression = list(expression)
    text = perform_substitutions(context, expression).strip().lower()
    if text in VALID_TRUE_EXPRESSIONS:
        return True
    if text in VALID_FALSE_EXPRESSIONS:
        return False
    valid = ', '.join(VALID_TRUE_EXPRESSIONS + VALID_FALSE_EXPRESSIONS)
    expanded_from = ' + '.join(repr(substitution) for substitution in expression)
    raise InvalidConditionExpressionError(
        f"invalid condition expression, expected one of [{valid}] but got '{text}', expanded from '{expanded_from}'"
    )
