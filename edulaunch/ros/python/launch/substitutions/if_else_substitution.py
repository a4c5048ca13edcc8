"""The substitution `IfElseSubstitution`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .._bases import ReadOnly
from ..substitution import SomeSubstitutionsType, Substitution
from ..utilities.texts import normalize_to_list_of_substitutions, perform_substitutions
from .boolean_substitution import truth
from .text_substitution import describe_all

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class IfElseSubstitution(Substitution):
    """`if_value` if the condition is true, and otherwise `else_value`. A condition is a boolean of YAML, 1 or 0.

    :raises RuntimeError: on creation, when both values are empty.
    """

    def __init__(
        self, condition: SomeSubstitutionsType, if_value: SomeSubstitutionsType = '', else_value: SomeSubstitutionsType = ''
    ) -> None:
        if if_value == else_value == '':
            raise RuntimeError('One of if_value and else_value must be specified')
        self.__condition = normalize_to_list_of_substitutions(condition)
        self.__if_value = normalize_to_list_of_substitutions(if_value)
        self.__else_value = normalize_to_list_of_substitutions(else_value)

    condition: ReadOnly[list[Substitution]] = ReadOnly('The condition, as substitutions.')
    if_value: ReadOnly[list[Substitution]] = ReadOnly('The value if the condition is true, as substitutions.')
    else_value: ReadOnly[list[Substitution]] = ReadOnly('The value if the condition is false, as substitutions.')

    def describe(self) -> str:
        """Return a description such as `IfElseSubstitution(condition, if_value, else_value)`."""
        parts = (self.__condition, self.__if_value, self.__else_value)
        return f'IfElseSubstitution({", ".join(describe_all(part) for part in parts)})'

    def perform(self, context: LaunchContext) -> str:
        """Return the value that the condition selects."""
        return perform_substitutions(context, self.__if_value if truth(context, self.__condition) else self.__else_value)
