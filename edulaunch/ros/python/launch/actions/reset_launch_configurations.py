"""The action `ResetLaunchConfigurations`."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, ClassVar

from .._bases import ReadOnly
from ..action import Action
from ..substitution import SomeSubstitutionsType
from ..utilities.texts import normalize_to_list_of_substitutions, perform_substitutions

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class ResetLaunchConfigurations(Action):
    """Delete all launch configurations, and then set the given configurations.

    :param launch_configurations: names and values, each a string or substitutions. They are evaluated before the configurations
        are deleted.
    """

    _search_role: ClassVar[str] = 'reset'

    def __init__(
        self, launch_configurations: Mapping[SomeSubstitutionsType, SomeSubstitutionsType] | None = None, **kwargs: Any
    ) -> None:
        super().__init__(**kwargs)
        self.__launch_configurations = dict(launch_configurations) if launch_configurations is not None else {}

    launch_configurations: ReadOnly[dict[SomeSubstitutionsType, SomeSubstitutionsType]] = ReadOnly(
        'The launch configurations to set afterwards.'
    )

    def execute(self, context: LaunchContext) -> None:
        """Delete all launch configurations, and then set the given configurations."""
        evaluated = {
            perform_substitutions(context, normalize_to_list_of_substitutions(name)): perform_substitutions(
                context, normalize_to_list_of_substitutions(value)
            )
            for name, value in self.__launch_configurations.items()
        }
        context.launch_configurations.clear()
        context.launch_configurations.update(evaluated)
