"""The substitution `FileContent`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .._bases import ReadOnly
from .._engine import inside
from ..substitution import SomeSubstitutionsType, Substitution
from ..utilities.texts import normalize_to_list_of_substitutions, perform_substitutions
from .substitution_failure import SubstitutionFailure
from .text_substitution import describe_all

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class FileContent(Substitution):
    """The content of a file.

    :raises SubstitutionFailure: on evaluation, when there is no such file.
    """

    def __init__(self, path: SomeSubstitutionsType) -> None:
        self.__path = normalize_to_list_of_substitutions(path)

    path: ReadOnly[list[Substitution]] = ReadOnly('The path, as substitutions.')

    def describe(self) -> str:
        """Return a description such as `FileContent('path')`."""
        return f'FileContent({describe_all(self.__path)})'

    def perform(self, context: LaunchContext) -> str:
        """Return the content of the file."""
        path = perform_substitutions(context, self.__path)
        try:
            with open(inside(path), encoding='utf-8') as file:
                return file.read()
        except FileNotFoundError as error:
            raise SubstitutionFailure(f'File not found: {path}') from error
