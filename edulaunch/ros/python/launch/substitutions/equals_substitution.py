"""The substitution `EqualsSubstitution`."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from .._bases import ReadOnly
from ..substitution import Substitution
from ..utilities.texts import normalize_to_list_of_substitutions, perform_substitutions
from ..utilities.type_utils import is_substitution
from .text_substitution import describe_all

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


_BOOLEANS = {'true': True, '1': True, 'false': False, '0': False}


class EqualsSubstitution(Substitution):
    """'true' if two values are equal, and otherwise 'false'.

    True, False, 1 and 0 are compared as booleans, and numbers as numbers. Nearly equal numbers count as equal. Other values are
    compared as strings.

    :param left: the first operand: substitutions or a plain value. None is the empty string; booleans are 'true' and 'false'.
    :param right: the second operand, with the same types as `left`.
    """

    def __init__(self, left: Any | None, right: Any | None) -> None:
        self.__left = _normalize_operand(left)
        self.__right = _normalize_operand(right)

    left: ReadOnly[list[Substitution]] = ReadOnly('The left operand.')
    right: ReadOnly[list[Substitution]] = ReadOnly('The right operand.')

    def describe(self) -> str:
        """Return a description such as `EqualsSubstitution('a' 'b')`."""
        return f'{type(self).__name__}({describe_all(self.__left)} {describe_all(self.__right)})'

    def perform(self, context: LaunchContext) -> str:
        """Return 'true' or 'false'."""
        return str(self._evaluate(context)).lower()

    def _evaluate(self, context: LaunchContext) -> bool:
        left = perform_substitutions(context, self.__left)
        right = perform_substitutions(context, self.__right)
        if left.lower() in _BOOLEANS and right.lower() in _BOOLEANS:
            return _BOOLEANS[left.lower()] == _BOOLEANS[right.lower()]
        try:
            return math.isclose(float(left), float(right))
        except ValueError:
            return left == right


def _normalize_operand(operand: Any) -> list[Substitution]:
    if is_substitution(operand):
        return normalize_to_list_of_substitutions(operand)
    if operand is None:
        return normalize_to_list_of_substitutions('')
    return normalize_to_list_of_substitutions(str(operand).lower() if isinstance(operand, bool) else str(operand))
