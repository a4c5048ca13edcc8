"""Conditions of actions."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, ClassVar

from ._bases import StableRepr
from ._lazy import has_ros_paths
from .substitution import SomeSubstitutionsType, Substitution
from .substitutions.text_substitution import describe_all
from .utilities.texts import normalize_to_list_of_substitutions, perform_substitutions

if TYPE_CHECKING:
    from .launch_context import LaunchContext


class Condition(StableRepr):
    """Decides at launch time whether an action is executed.

    :param predicate: called with the launch context; without one the condition is false.
    """

    def __init__(self, *, predicate: Callable[[LaunchContext], bool] | None = None) -> None:
        self._predicate = predicate

    @property
    def in_words(self) -> str:
        """The condition in words, for a plan. (edulaunch only.)"""
        return f'if {type(self).__name__} says so'

    def describe(self) -> str:
        """What people read; here as `repr` writes it."""
        return repr(self)

    def evaluate(self, context: LaunchContext) -> bool:
        """True or False, now."""
        return self._predicate(context) if self._predicate is not None else False


class InvalidConditionExpressionError(ValueError):
    """The text of a condition is none of true, 1, false and 0."""


VALID_TRUE_EXPRESSIONS = ['true', '1']
VALID_FALSE_EXPRESSIONS = ['false', '0']


def evaluate_condition_expression(context: LaunchContext, expression: Iterable[Substitution]) -> bool:
    """Join the substitutions; `true` and `1` are true, `false` and `0` are false, in any case, with spaces
    around.

    :raises InvalidConditionExpressionError: for any other text, 'yes' and 'on' included.
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
        """`IfCondition(LaunchConfig('x'))`."""
        return f'{self._word.capitalize()}Condition({describe_all(self._expression)})'

    def _predicate_func(self, context: LaunchContext) -> bool:
        return evaluate_condition_expression(context, self._expression) == (self._word == 'if')


class IfCondition(_ExpressionCondition):
    """Execute the action only if the expression is `true` or `1` (any case); `false` and `0` are the only
    other texts.

    :raises InvalidConditionExpressionError: on evaluation, for any other text.
    """

    _word = 'if'


class UnlessCondition(_ExpressionCondition):
    """Execute the action only if the expression is `false` or `0` (any case).

    :raises InvalidConditionExpressionError: on evaluation, for a text that is neither true nor false.
    """

    _word = 'unless'


class LaunchConfigurationEquals(Condition):
    """True when the launch configuration has exactly the expected text; an expected None means "is not set".

    Deprecated upstream in favour of `IfCondition(EqualsSubstitution(...))`; making one warns.
    """

    def __init__(self, launch_configuration_name: str, expected_value: SomeSubstitutionsType | None) -> None:
        warnings.warn(
            "The 'LaunchConfigurationEquals' and 'LaunchConfigurationNotEquals' Conditions are deprecated. "
            "Use the 'EqualsSubstitution' and 'NotEqualsSubstitution' substitutions instead! E.g.:\n"
            f"  IfCondition(EqualsSubstitution(LaunchConfiguration('{launch_configuration_name}'), ...))",
            UserWarning,
            stacklevel=2,
        )
        self.__name = launch_configuration_name
        self.__expected = None if expected_value is None else normalize_to_list_of_substitutions(expected_value)
        super().__init__(predicate=self._predicate_func)

    _sign = 'is'

    @property
    def in_words(self) -> str:
        return f"if '{self.__name}' {self._sign} {'unset' if self.__expected is None else describe_all(self.__expected)}"

    def _predicate_func(self, context: LaunchContext) -> bool:
        expected = None if self.__expected is None else perform_substitutions(context, self.__expected)
        return bool(context.launch_configurations.get(self.__name) == expected)


class LaunchConfigurationNotEquals(LaunchConfigurationEquals):
    """True when the launch configuration has not exactly the given text; None means "is set"."""

    _sign = 'is not'

    def _predicate_func(self, context: LaunchContext) -> bool:
        return not super()._predicate_func(context)


has_ros_paths(__name__)
has_ros_paths(
    __name__,
    'IfCondition InvalidConditionExpressionError LaunchConfigurationEquals LaunchConfigurationNotEquals UnlessCondition '
    'evaluate_condition_expression=evaluate_condition_expression_impl',
)
