"""The action `UnsetLaunchConfiguration`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .._bases import ReadOnly
from ..action import Action
from ..substitution import SomeSubstitutionsType, Substitution
from ..utilities.texts import normalize_to_list_of_substitutions, perform_substitutions

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class UnsetLaunchConfiguration(Action):
    """Remove a launch configuration. The action has no effect if the configuration is not set."""

    def __init__(self, name: SomeSubstitutionsType, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__name = normalize_to_list_of_substitutions(name)

    name: ReadOnly[list[Substitution]] = ReadOnly('The name, as substitutions.')

    def execute(self, context: LaunchContext) -> None:
        """Remove the launch configuration."""
        context.launch_configurations.pop(perform_substitutions(context, self.__name), None)
