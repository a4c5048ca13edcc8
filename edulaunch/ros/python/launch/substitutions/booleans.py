"""Texts compared, and combined as booleans; the results are 'true' and 'false'."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any, ClassVar

from .._bases import ReadOnly
from .._lazy import has_ros_paths
from ..substitution import SomeSubstitutionsType, Substitution
from ..utilities.texts import normalize_to_list_of_substitutions, perform_substitutions
from ..utilities.type_utils import coerce_to_type, is_substitution
from .text_substitution import SubstitutionFailure, describe_all

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


def truth(context: LaunchContext, substitutions: Iterable[Substitution]) -> bool:
    """YAML's booleans (true, yes, on ...) and 1 and 0.

    :raises SubstitutionFailure: for any other text.
    """
    try:
        return bool(coerce_to_type(perform_substitutions(context, substitutions), bool))
    except ValueError as error:
        raise SubstitutionFailure(str(error)) from error


class NotSubstitution(Substitution):
    """The opposite."""

    def __init__(self, value: SomeSubstitutionsType) -> None:
        self.__value = normalize_to_list_of_substitutions(value)

    value: ReadOnly[list[Substitution]] = ReadOnly('The operand.')

    def describe(self) -> str:
        """`NotSubstitution(value)`."""
        return f'NotSubstitution({describe_all(self.__value)})'

    def perform(self, context: LaunchContext) -> str:
        """'true' or 'false'."""
        return _text(not truth(context, self.__value))


class _Combined(Substitution):
    """Several operands, of which `_combine` makes one answer."""

    _combine: ClassVar[Callable[[Iterable[bool]], bool]]

    def __init__(self, *args: SomeSubstitutionsType) -> None:
        self._operands = [normalize_to_list_of_substitutions(arg) for arg in args]

    def describe(self) -> str:
        """`AndSubstitution(left right)`."""
        return f'{type(self).__name__}({" ".join(describe_all(operand) for operand in self._operands)})'

    def perform(self, context: LaunchContext) -> str:
        """'true' or 'false'."""
        # A list, so that every operand is evaluated and checked.
        return _text(type(self)._combine([truth(context, operand) for operand in self._operands]))


class _CombinedPair(_Combined):
    def __init__(self, left: SomeSubstitutionsType, right: SomeSubstitutionsType) -> None:
        super().__init__(left, right)

    @property
    def left(self) -> list[Substitution]:
        """The left operand."""
        return self._operands[0]

    @property
    def right(self) -> list[Substitution]:
        """The right operand."""
        return self._operands[1]


class AndSubstitution(_CombinedPair):
    """Whether both are true."""

    _combine = all


class OrSubstitution(_CombinedPair):
    """Whether at least one of two is true."""

    _combine = any


class _CombinedMany(_Combined):
    args: ReadOnly[list[list[Substitution]]] = ReadOnly('The operands.', '_operands')


class AnySubstitution(_CombinedMany):
    """Whether at least one is true; false for none."""

    _combine = any

    def __init__(self, *args: SomeSubstitutionsType) -> None:  # its own, because upstream's $(any ...) fails with its name
        super().__init__(*args)


class AllSubstitution(_CombinedMany):
    """Whether all are true; true for none."""

    _combine = all

    def __init__(self, *args: SomeSubstitutionsType) -> None:  # its own, because upstream's $(all ...) fails with its name
        super().__init__(*args)


def _text(value: bool) -> str:
    return str(value).lower()


_BOOLEANS = {'true': True, '1': True, 'false': False, '0': False}


class EqualsSubstitution(Substitution):
    """'true' or 'false'. True, False, 1 and 0 compare as booleans, numbers as numbers (nearly equal is
    equal), else texts.

    :param left, right: substitutions, or plain values: None is the empty text, booleans are 'true' and
        'false'.
    """

    def __init__(self, left: Any | None, right: Any | None) -> None:
        self.__left = _normalize_operand(left)
        self.__right = _normalize_operand(right)

    left: ReadOnly[list[Substitution]] = ReadOnly('The left operand.')
    right: ReadOnly[list[Substitution]] = ReadOnly('The right operand.')

    def describe(self) -> str:
        """`EqualsSubstitution('a' 'b')`."""
        return f'{type(self).__name__}({describe_all(self.__left)} {describe_all(self.__right)})'

    def perform(self, context: LaunchContext) -> str:
        """'true' or 'false'."""
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


class NotEqualsSubstitution(EqualsSubstitution):
    """The opposite of `EqualsSubstitution`."""

    def _evaluate(self, context: LaunchContext) -> bool:
        return not super()._evaluate(context)


class IfElseSubstitution(Substitution):
    """`if_value` when the condition is true, else `else_value`. Booleans are YAML's, and 1 and 0.

    :raises RuntimeError: when both values are empty.
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
    if_value: ReadOnly[list[Substitution]] = ReadOnly('The text when true, as substitutions.')
    else_value: ReadOnly[list[Substitution]] = ReadOnly('The text when false, as substitutions.')

    def describe(self) -> str:
        """`IfElseSubstitution(condition, if_value, else_value)`."""
        parts = (self.__condition, self.__if_value, self.__else_value)
        return f'IfElseSubstitution({", ".join(describe_all(part) for part in parts)})'

    def perform(self, context: LaunchContext) -> str:
        """The chosen text."""
        return perform_substitutions(context, self.__if_value if truth(context, self.__condition) else self.__else_value)


has_ros_paths(__name__)
