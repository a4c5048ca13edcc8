"""The action `SetLaunchConfiguration`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .._bases import ReadOnly
from ..action import Action
from ..substitution import SomeSubstitutionsType, Substitution
from ..utilities.texts import normalize_to_list_of_substitutions, perform_substitutions

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class SetLaunchConfiguration(Action):
    """Set a launch configuration, even if it is already set. It also overrides a user's `name:=value`.

    :param name: the name of the launch configuration; a string or substitutions.
    :param value: the new value; a string or substitutions.
    """

    def __init__(self, name: SomeSubstitutionsType, value: SomeSubstitutionsType, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__name = normalize_to_list_of_substitutions(name)
        self.__value = normalize_to_list_of_substitutions(value)

    name: ReadOnly[list[Substitution]] = ReadOnly('The name, as substitutions.')
    value: ReadOnly[list[Substitution]] = ReadOnly('The value, as substitutions.')

    def execute(self, context: LaunchContext) -> None:
        """Set the launch configuration."""
        name = perform_substitutions(context, self.__name)
        context.launch_configurations[name] = perform_substitutions(context, self.__value)
