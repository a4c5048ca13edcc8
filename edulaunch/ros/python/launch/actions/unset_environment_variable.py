"""The action `UnsetEnvironmentVariable`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .._bases import ReadOnly
from ..action import Action
from ..substitution import SomeSubstitutionsType, Substitution
from ..utilities.texts import normalize_to_list_of_substitutions, perform_substitutions

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class UnsetEnvironmentVariable(Action):
    """Remove an environment variable of launch's process. The action has no effect if the variable is not set."""

    def __init__(self, name: SomeSubstitutionsType, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__name = normalize_to_list_of_substitutions(name)

    name: ReadOnly[list[Substitution]] = ReadOnly('The name, as substitutions.')

    def execute(self, context: LaunchContext) -> None:
        """Unset the variable."""
        context.environment.pop(perform_substitutions(context, self.__name), None)
