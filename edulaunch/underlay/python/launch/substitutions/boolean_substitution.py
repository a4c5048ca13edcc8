"""Texts combined as booleans. All operands are always evaluated; the results are 'true' and 'false'."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, ClassVar

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
    @property
    def args(self) -> list[list[Substitution]]:
        """The operands."""
        return self._operands


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
