"""Texts combined as booleans. All operands are always evaluated; the results are 'true' and 'false'."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from .._read_only import ReadOnly
from ..some_substitutions_type import SomeSubstitutionsType
from ..substitution import Substitution
from ..utilities.normalize_to_list_of_substitutions_impl import normalize_to_list_of_substitutions
from ._description import describe_all
from ._truth import truth

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


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


class AndSubstitution(Substitution):
    """Whether both are true."""

    def __init__(self, left: SomeSubstitutionsType, right: SomeSubstitutionsType) -> None:
        self.__left = normalize_to_list_of_substitutions(left)
        self.__right = normalize_to_list_of_substitutions(right)

    left: ReadOnly[list[Substitution]] = ReadOnly('The left operand.')
    right: ReadOnly[list[Substitution]] = ReadOnly('The right operand.')

    def describe(self) -> str:
        """`AndSubstitution(left right)`."""
        return f'AndSubstitution({describe_all(self.__left)} {describe_all(self.__right)})'

    def perform(self, context: LaunchContext) -> str:
        """'true' or 'false'."""
        return _text(all(_truths(context, (self.__left, self.__right))))


class OrSubstitution(Substitution):
    """Whether at least one of two is true."""

    def __init__(self, left: SomeSubstitutionsType, right: SomeSubstitutionsType) -> None:
        self.__left = normalize_to_list_of_substitutions(left)
        self.__right = normalize_to_list_of_substitutions(right)

    left: ReadOnly[list[Substitution]] = ReadOnly('The left operand.')
    right: ReadOnly[list[Substitution]] = ReadOnly('The right operand.')

    def describe(self) -> str:
        """`OrSubstitution(left right)`."""
        return f'OrSubstitution({describe_all(self.__left)} {describe_all(self.__right)})'

    def perform(self, context: LaunchContext) -> str:
        """'true' or 'false'."""
        return _text(any(_truths(context, (self.__left, self.__right))))


class AnySubstitution(Substitution):
    """Whether at least one is true; false for none."""

    def __init__(self, *args: SomeSubstitutionsType) -> None:
        self.__args = [normalize_to_list_of_substitutions(arg) for arg in args]

    args: ReadOnly[list[list[Substitution]]] = ReadOnly('The operands.')

    def describe(self) -> str:
        """`AnySubstitution(a b)`."""
        return f'AnySubstitution({" ".join(describe_all(arg) for arg in self.__args)})'

    def perform(self, context: LaunchContext) -> str:
        """'true' or 'false'."""
        return _text(any(_truths(context, self.__args)))


class AllSubstitution(Substitution):
    """Whether all are true; true for none."""

    def __init__(self, *args: SomeSubstitutionsType) -> None:
        self.__args = [normalize_to_list_of_substitutions(arg) for arg in args]

    args: ReadOnly[list[list[Substitution]]] = ReadOnly('The operands.')

    def describe(self) -> str:
        """`AllSubstitution(a b)`."""
        return f'AllSubstitution({" ".join(describe_all(arg) for arg in self.__args)})'

    def perform(self, context: LaunchContext) -> str:
        """'true' or 'false'."""
        return _text(all(_truths(context, self.__args)))


def _truths(context: LaunchContext, operands: Iterable[list[Substitution]]) -> list[bool]:
    """A list, so that every operand is evaluated and checked."""
    return [truth(context, operand) for operand in operands]


def _text(value: bool) -> str:
    return str(value).lower()
