"""The base class of conditions that convert a string to a boolean."""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

from ..condition import Condition
from ..substitution import SomeSubstitutionsType
from ..substitutions.text_substitution import describe_all
from ..utilities.texts import normalize_to_list_of_substitutions
from .evaluate_condition_expression_impl import evaluate_condition_expression

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class _ExpressionCondition(Condition):
    """A condition whose name in a launch file is `_word`."""

    _word: ClassVar[str]

    def __init__(self, predicate_expression: SomeSubstitutionsType) -> None:
        self._expression = normalize_to_list_of_substitutions(predicate_expression)
        super().__init__(predicate=self._predicate_func)

    @property
    def in_words(self) -> str:
        return f'{self._word} {describe_all(self._expression)}'

    def describe(self) -> str:
        """Return a description such as `IfCondition(LaunchConfig('x'))`."""
        return f'{self._word.capitalize()}Condition({describe_all(self._expression)})'

    def _predicate_func(self, context: LaunchContext) -> bool:
        return evaluate_condition_expression(context, self._expression) == (self._word == 'if')
