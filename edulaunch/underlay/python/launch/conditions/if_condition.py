"""A condition that is true for `true` and `1`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..condition import Condition
from ..some_substitutions_type import SomeSubstitutionsType
from ..utilities.normalize_to_list_of_substitutions_impl import normalize_to_list_of_substitutions
from .evaluate_condition_expression_impl import evaluate_condition_expression

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class IfCondition(Condition):
    """Execute the action only if the expression is `true` or `1` (any case); `false` and `0` are the only
    other texts.

    :raises InvalidConditionExpressionError: on evaluation, for any other text.
    """

    def __init__(self, predicate_expression: SomeSubstitutionsType) -> None:
        self.__predicate_expression = normalize_to_list_of_substitutions(predicate_expression)
        super().__init__(predicate=self._predicate_func)

    @property
    def in_words(self) -> str:
        return 'if ' + ' + '.join(part.describe() for part in self.__predicate_expression)

    def describe(self) -> str:
        """`IfCondition(LaunchConfig('x'))`."""
        return f'IfCondition({" + ".join(part.describe() for part in self.__predicate_expression)})'

    def _predicate_func(self, context: LaunchContext) -> bool:
        return evaluate_condition_expression(context, self.__predicate_expression)
