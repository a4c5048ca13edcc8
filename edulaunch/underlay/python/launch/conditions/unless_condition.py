"""The opposite of `IfCondition`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..condition import Condition
from ..some_substitutions_type import SomeSubstitutionsType
from ..utilities.normalize_to_list_of_substitutions_impl import normalize_to_list_of_substitutions
from .evaluate_condition_expression_impl import evaluate_condition_expression

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class UnlessCondition(Condition):
    """Execute the action only if the expression is `false` or `0` (any case).

    :raises InvalidConditionExpressionError: on evaluation, for a text that is neither true nor false.
    """

    def __init__(self, predicate_expression: SomeSubstitutionsType) -> None:
        self.__predicate_expression = normalize_to_list_of_substitutions(predicate_expression)
        super().__init__(predicate=self._predicate_func)

    @property
    def in_words(self) -> str:
        return 'unless ' + ' + '.join(part.describe() for part in self.__predicate_expression)

    def describe(self) -> str:
        """`UnlessCondition(LaunchConfig('x'))`."""
        return f'UnlessCondition({" + ".join(part.describe() for part in self.__predicate_expression)})'

    def _predicate_func(self, context: LaunchContext) -> bool:
        return not evaluate_condition_expression(context, self.__predicate_expression)
