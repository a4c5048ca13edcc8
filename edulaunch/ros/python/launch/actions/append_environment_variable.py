"""The action `AppendEnvironmentVariable`."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

from .._bases import ReadOnly
from ..action import Action
from ..substitution import SomeSubstitutionsType, Substitution
from ..utilities.texts import normalize_to_list_of_substitutions, perform_substitutions
from ..utilities.type_utils import is_substitution, normalize_typed_substitution, perform_typed_substitution

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class AppendEnvironmentVariable(Action):
    """Add a value at the end or the beginning of an environment variable that is a list. Create the variable if it does not
    exist.

    :param prepend: whether to add at the beginning; a boolean, or substitutions that give a boolean.
    :param separator: the string between the values. The default is the separator of search paths.
    """

    def __init__(
        self,
        name: SomeSubstitutionsType,
        value: SomeSubstitutionsType,
        prepend: bool | SomeSubstitutionsType = False,
        separator: SomeSubstitutionsType = os.pathsep,
        **kwargs: Any,
    ) -> None:
        super().__init__(**kwargs)
        self.__name = normalize_to_list_of_substitutions(name)
        self.__value = normalize_to_list_of_substitutions(value)
        as_text = isinstance(prepend, str) or is_substitution(prepend)
        value_of_prepend: Any = prepend
        self.__prepend: Any = (
            normalize_to_list_of_substitutions(value_of_prepend)
            if as_text
            else normalize_typed_substitution(value_of_prepend, bool)
        )
        self.__separator = normalize_to_list_of_substitutions(separator)

    name: ReadOnly[list[Substitution]] = ReadOnly('The name, as substitutions.')
    value: ReadOnly[list[Substitution]] = ReadOnly('The value, as substitutions.')

    @property
    def prepend(self) -> bool | list[Substitution]:
        """Whether the value is added at the beginning."""
        prepend: bool | list[Substitution] = self.__prepend
        return prepend

    separator: ReadOnly[list[Substitution]] = ReadOnly('The separator of the values, as substitutions.')

    def execute(self, context: LaunchContext) -> None:
        """Add the value to the variable."""
        name = perform_substitutions(context, self.__name)
        value = perform_substitutions(context, self.__value)
        if name in context.environment:
            old = context.environment[name]
            parts = [value, old] if perform_typed_substitution(context, self.__prepend, bool) else [old, value]
            value = perform_substitutions(context, self.__separator).join(parts)
        context.environment[name] = value
