"""Substitutions for boolean operations, with the results 'true' and 'false'."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, ClassVar

from .._bases import ReadOnly
from ..substitution import SomeSubstitutionsType, Substitution
from ..utilities.texts import normalize_to_list_of_substitutions, perform_substitutions
from ..utilities.type_utils import coerce_to_type
from .substitution_failure import SubstitutionFailure
from .text_substitution import describe_all

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


def truth(context: LaunchContext, substitutions: Iterable[Substitution]) -> bool:
    """Return the boolean value of a string: a boolean of YAML (true, yes, on ...), 1 or 0.

    :raises SubstitutionFailure: for any other string.
    """
    try:
        return bool(coerce_to_type(perform_substitutions(context, substitutions), bool))
    except ValueError as error:
        raise SubstitutionFailure(str(error)) from error


class NotSubstitution(Substitution):
    """The negation of a boolean, as 'true' or 'false'."""

    def __init__(self, value: SomeSubstitutionsType) -> None:
        self.__value = normalize_to_list_of_substitutions(value)

    value: ReadOnly[list[Substitution]] = ReadOnly('The operand.')

    def describe(self) -> str:
        """Return a description such as `NotSubstitution(value)`."""
        return f'NotSubstitution({describe_all(self.__value)})'

    def perform(self, context: LaunchContext) -> str:
        """Return 'true' or 'false'."""
        return _text(not truth(context, self.__value))


class _Combined(Substitution):
    """Several operands, which `_combine` combines into one value."""

    _combine: ClassVar[Callable[[Iterable[bool]], bool]]

    def __init__(self, *args: SomeSubstitutionsType) -> None:
        self._operands = [normalize_to_list_of_substitutions(arg) for arg in args]

    def describe(self) -> str:
        """Return a description such as `AndSubstitution(left right)`."""
        return f'{type(self).__name__}({" ".join(describe_all(operand) for operand in self._operands)})'

    def perform(self, context: LaunchContext) -> str:
        """Return 'true' or 'false'."""
        # The list makes sure that every operand is evaluated and checked.
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
    """'true' if both booleans are true, and otherwise 'false'."""

    _combine = all


class OrSubstitution(_CombinedPair):
    """'true' if at least one of two booleans is true, and otherwise 'false'."""

    _combine = any


class _CombinedMany(_Combined):
    args: ReadOnly[list[list[Substitution]]] = ReadOnly('The operands.', '_operands')


class AnySubstitution(_CombinedMany):
    """'true' if at least one boolean is true, and otherwise 'false', also for an empty list."""

    _combine = any

    def __init__(self, *args: SomeSubstitutionsType) -> None:  # upstream's error for $(any ...) names this __init__
        super().__init__(*args)


class AllSubstitution(_CombinedMany):
    """'true' if all booleans are true, also for an empty list. Otherwise 'false'."""

    _combine = all

    def __init__(self, *args: SomeSubstitutionsType) -> None:  # upstream's error for $(all ...) names this __init__
        super().__init__(*args)


def _text(value: bool) -> str:
    return str(value).lower()
