"""The substitution `StringJoinSubstitution`."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from .._bases import ReadOnly
from ..substitution import SomeSubstitutionsType, Substitution
from ..utilities.texts import normalize_to_list_of_substitutions, perform_substitutions
from .text_substitution import describe_all

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class StringJoinSubstitution(Substitution):
    """The parts, joined with `delimiter` between them. The class is newer than Jazzy's first release."""

    def __init__(self, substitutions: Iterable[SomeSubstitutionsType], delimiter: SomeSubstitutionsType = '') -> None:
        self.__substitutions = [normalize_to_list_of_substitutions(part) for part in substitutions]
        self.__delimiter = normalize_to_list_of_substitutions(delimiter)

    substitutions: ReadOnly[list[list[Substitution]]] = ReadOnly('The parts, each a list of substitutions.')
    delimiter: ReadOnly[list[Substitution]] = ReadOnly('The separator of the parts, as substitutions.')

    def describe(self) -> str:
        """Return a description such as `StringJoin('a' + 'b')`."""
        return f'StringJoin({" + ".join(describe_all(part) for part in self.__substitutions)})'

    def perform(self, context: LaunchContext) -> str:
        """Return the joined string."""
        delimiter = perform_substitutions(context, self.__delimiter)
        return delimiter.join(perform_substitutions(context, part) for part in self.__substitutions)
