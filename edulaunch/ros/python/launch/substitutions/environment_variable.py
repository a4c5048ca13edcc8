"""The substitution `EnvironmentVariable`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from edulaunch.engine.facts import with_facts
from edulaunch.engine.nearest import nearest_spelling

from .._bases import ReadOnly
from ..substitution import SomeSubstitutionsType, Substitution
from ..utilities.texts import normalize_to_list_of_substitutions, perform_substitutions
from .substitution_failure import SubstitutionFailure
from .text_substitution import describe_all

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class EnvironmentVariable(Substitution):
    """The current value of an environment variable of launch's process.

    :raises SubstitutionFailure: on evaluation, when the variable is not set and there is no default.
    """

    def __init__(self, name: SomeSubstitutionsType, *, default_value: SomeSubstitutionsType | None = None) -> None:
        self.__name = normalize_to_list_of_substitutions(name)
        self.__default_value = None if default_value is None else normalize_to_list_of_substitutions(default_value)

    name: ReadOnly[list[Substitution]] = ReadOnly('The name, as substitutions.')
    default_value: ReadOnly[list[Substitution] | None] = ReadOnly('The default, as substitutions, or None.')

    def describe(self) -> str:
        """Return a description such as `EnvVar('NAME')`."""
        return f'EnvVar({describe_all(self.__name)})'

    def perform(self, context: LaunchContext) -> str:
        """Return the value of the variable, or the default."""
        name = perform_substitutions(context, self.__name)
        value = context.environment.get(name)
        if value is not None:
            return value
        if self.__default_value is None:
            error = SubstitutionFailure(f"environment variable '{name}' does not exist")
            raise with_facts(error, 'launch.no-variable', near=nearest_spelling(name, context.environment))
        return perform_substitutions(context, self.__default_value)
