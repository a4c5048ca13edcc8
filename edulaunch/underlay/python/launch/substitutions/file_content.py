"""The text of a file."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .._read_only import ReadOnly
from ..some_substitutions_type import SomeSubstitutionsType
from ..substitution import Substitution
from ..utilities.normalize_to_list_of_substitutions_impl import normalize_to_list_of_substitutions
from ..utilities.perform_substitutions_impl import perform_substitutions
from ._description import describe_all
from .substitution_failure import SubstitutionFailure

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class FileContent(Substitution):
    """The whole text of a file.

    :raises SubstitutionFailure: on evaluation, when there is no such file.
    """

    def __init__(self, path: SomeSubstitutionsType) -> None:
        self.__path = normalize_to_list_of_substitutions(path)

    path: ReadOnly[list[Substitution]] = ReadOnly('The path, as substitutions.')

    def describe(self) -> str:
        """`FileContent('path')`."""
        return f'FileContent({describe_all(self.__path)})'

    def perform(self, context: LaunchContext) -> str:
        """The text."""
        path = perform_substitutions(context, self.__path)
        try:
            with open(path, encoding='utf-8') as file:
                return file.read()
        except FileNotFoundError as error:
            raise SubstitutionFailure(f'File not found: {path}') from error
